#pragma once

#include <rosbag/bag.h>

namespace markerless_mocap {

/// Hold one while several threads open bags. rosbag 1.15 loads a plugin with the first bag of a
/// process and unloads it with the last one; threads that do both at once crash.
class BagsInThreads {
 private:
  rosbag::Bag kept_;
};

}  // namespace markerless_mocap
