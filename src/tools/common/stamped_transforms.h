#pragma once

#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// The transforms of a recording by stamp. Unlike tf2, it does not interpolate: a frame is known at
/// a stamp only if all moving transforms between it and the root have this stamp.
class StampedTransforms {
 public:
  void add(const tf2_msgs::TFMessage& message, bool is_static);

  /// Stamps at which the transform of the frame was published, ascending, ns.
  std::vector<int64_t> stampsOf(const std::string& frame) const;
  /// Moving frames whose names begin with the text.
  std::vector<std::string> framesBeginningWith(const std::string& text) const;

  struct Place {
    std::string root;  ///< root frame of the tree; empty: the frame is unknown
    Eigen::Isometry3d T_root_frame;
  };
  Place find(const std::string& frame, int64_t stamp_ns) const;

 private:
  using Parent = std::pair<std::string, Eigen::Isometry3d>;  ///< name, T_parent_child
  using Parents = std::map<std::string, Parent>;             ///< by child

  Parents statics_;
  std::map<int64_t, Parents> moving_;
};

}  // namespace markerless_mocap
