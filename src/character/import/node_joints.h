#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motion/bone_names.h"

struct aiBone;
struct aiMesh;
struct aiNode;
struct aiScene;
template <typename T>
class aiMatrix4x4t;

namespace markerless_mocap {

Eigen::Matrix4d matrixOf(const aiMatrix4x4t<float>& matrix);
/// From the node's axes to the scene's.
Eigen::Matrix4d nodeTransform(const aiNode& node);

/// The nodes of a scene that make its rig: bones, what carries them and what hangs on them, without
/// nodes of meshes.
class NodeJoints {
 public:
  /// \param scene in which each bone has a node
  explicit NodeJoints(const aiScene& scene);

  const std::vector<NamedJoint>& joints() const { return joints_; }
  /// From each joint's axes to the scene's as the nodes stand.
  const std::vector<Eigen::Matrix4d>& nodeTransforms() const { return transforms_; }
  /// From each joint's axes to those that the largest mesh was made in (mirrored where the scene
  /// mirrors it), in the pose in which the meshes were fastened. Joints without a place of their
  /// own in that pose stand to their neighbours as the nodes do.
  std::vector<Eigen::Matrix4d> bindTransforms() const;

  size_t jointOf(const aiBone& bone) const;
  /// The bone, or joint below a bone, that is the node or next above it; none if there is none.
  std::optional<size_t> carrierOf(const aiNode& node) const;

 private:
  using Known = std::vector<std::optional<Eigen::Matrix4d>>;

  bool holdsBone(const aiNode& node) const;
  void collect(const aiNode& node, int parent, bool below_bone);
  Eigen::Matrix4d meshFrame(const aiMesh& mesh, const Known& known) const;
  void fillGaps(Known& known) const;

  const aiScene& scene_;
  std::set<std::string> bone_names_;
  std::map<std::string, size_t> joint_of_bone_;
  std::map<const aiNode*, size_t> joint_of_node_;
  std::vector<NamedJoint> joints_;
  std::vector<Eigen::Matrix4d> transforms_;
};

}  // namespace markerless_mocap
