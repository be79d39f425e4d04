#pragma once

#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// The transforms of a recording by their stamps. Unlike tf2 it does not interpolate: a frame is
/// known at a stamp only if all that moves on its way to the root was said at that stamp.
class StampedTransforms {
 public:
  void add(const tf2_msgs::TFMessage& message, bool is_static);

  /// Stamps at which the frame itself was said, ascending, ns.
  std::vector<int64_t> stampsOf(const std::string& frame) const;
  /// Frames said to move that begin with the text.
  std::vector<std::string> framesBeginningWith(const std::string& text) const;

  struct Place {
    std::string root;  ///< frame at the top of the tree; empty: the frame is not known
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
