#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "formats/parts/layout.h"

namespace markerless_mocap {

/// Whether a text has static transforms: a launch file with static_transform_publisher nodes, or
/// YAML with geometry_msgs/TransformStamped messages, as rostopic echo /tf_static prints them.
bool holdsTransforms(const std::string& text);

/// A tree of frames.
class StaticTransforms {
 public:
  /// Throws std::invalid_argument if a transform is not complete or a frame has two parents.
  void add(const TextFile& file);

  /// Pose of a camera's optical frame in the root of the tree: of the frame <camera>_optical_frame,
  /// <camera>_optical or <camera>. Throws std::invalid_argument if there is none, or if its root is
  /// not that of the cameras before it.
  Eigen::Isometry3d poseOfCamera(const std::string& camera, const std::string& where,
                                 std::vector<std::string>* remarks);

 private:
  struct Link {
    std::string parent;
    Eigen::Isometry3d T_parent_child;
  };

  void addLink(const std::string& parent, const std::string& child, const Eigen::Isometry3d& T,
               const std::string& where);
  void addLaunch(const TextFile& file);
  void addYaml(const TextFile& file);
  std::string frameOfCamera(const std::string& camera, const std::string& where,
                            std::vector<std::string>* remarks) const;

  std::map<std::string, Link> links_;  ///< by child
  std::string root_;
};

}  // namespace markerless_mocap
