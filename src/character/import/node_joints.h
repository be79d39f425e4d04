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
/// Transform from the node's axes to the scene's.
Eigen::Matrix4d nodeTransform(const aiNode& node);

/// The nodes of a scene that form its rig: bones, their ancestors and descendants, without nodes of
/// meshes.
class NodeJoints {
 public:
  /// \param scene scene in which each bone has a node
  explicit NodeJoints(const aiScene& scene);

  const std::vector<NamedJoint>& joints() const { return joints_; }
  /// Transforms from each joint's axes to the scene's, in the pose of the nodes.
  const std::vector<Eigen::Matrix4d>& nodeTransforms() const { return transforms_; }
  /// Transforms from each joint's axes to those of the largest mesh (mirrored if the scene mirrors
  /// it), in the bind pose. Joints without a bind transform have the same transform to their
  /// neighbours as in the pose of the nodes.
  std::vector<Eigen::Matrix4d> bindTransforms() const;

  size_t jointOf(const aiBone& bone) const;
  /// The joint of a node, or the nearest joint above it that is a bone or below one; empty if there
  /// is none.
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
