#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "ros/rig_collector.h"

namespace markerless_mocap {

/// What tf said last of each frame. Stamps do not count: once a sender's clock was ahead, tf2 would
/// take nothing from it until the clock comes there again. Thread-safe.
class LatestTransforms {
 public:
  /// \param arrival_ns by a clock that is never set, above 0
  void add(const tf2_msgs::TFMessage& message, const std::string& sender, bool is_static,
           int64_t arrival_ns);
  const tf2::BufferCore& buffer() const { return buffer_; }
  /// Of transforms between a camera of the rig and the world that tf2 does not take, as long as
  /// none of the same frame has come that it takes.
  std::vector<std::string> faults(const RigCollector& rig) const;

 private:
  mutable std::mutex mutex_;
  tf2::BufferCore buffer_;
  std::map<std::string, std::string> faults_;  ///< by child frame
};

}  // namespace markerless_mocap
