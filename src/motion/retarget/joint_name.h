#pragma once

#include <string>

namespace markerless_mocap {

/// The components of a joint's name. "mixamorig:LeftForeArm", "forearm.L" and "lForeArm" all give
/// side 'l' and word "forearm".
struct JointName {
  char side = ' ';      ///< 'l', 'r' or ' ' for neither
  std::string word;     ///< lower-case letters, without side, numbers and prefixes
  int number = 0;       ///< the first number in the name; 0: none
  bool helper = false;  ///< a control, twist joint or similar, never a bone
};

JointName parseJointName(const std::string& name);

}  // namespace markerless_mocap
