#include "character/import/node_joints.h"

#include <assimp/scene.h>

#include <Eigen/LU>
#include <algorithm>

namespace markerless_mocap {

using Eigen::Matrix4d;

Matrix4d matrixOf(const aiMatrix4x4& m) {
  Matrix4d matrix;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column) matrix(row, column) = double(m[row][column]);
  return matrix;
}

Matrix4d nodeTransform(const aiNode& node) {
  const Matrix4d own = matrixOf(node.mTransformation);
  return node.mParent ? Matrix4d(nodeTransform(*node.mParent) * own) : own;
}

NodeJoints::NodeJoints(const aiScene& scene) : scene_(scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b)
      bone_names_.insert(scene.mMeshes[m]->mBones[b]->mName.C_Str());
  collect(*scene.mRootNode, -1, false);
}

bool NodeJoints::holdsBone(const aiNode& node) const {
  if (bone_names_.count(node.mName.C_Str())) return true;
  return std::any_of(node.mChildren, node.mChildren + node.mNumChildren,
                     [&](const aiNode* child) { return holdsBone(*child); });
}

void NodeJoints::collect(const aiNode& node, int parent, bool below_bone) {
  const bool is_bone = bone_names_.count(node.mName.C_Str()) > 0;
  below_bone |= is_bone;
  if (holdsBone(node) || (below_bone && node.mNumMeshes == 0)) {
    const size_t joint = joints_.size();
    joints_.push_back({node.mName.C_Str(), parent});
    transforms_.push_back(nodeTransform(node));
    if (below_bone) joint_of_node_[&node] = joint;
    if (is_bone) joint_of_bone_.emplace(node.mName.C_Str(), joint);
    parent = int(joint);
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) collect(*node.mChildren[c], parent, below_bone);
}

size_t NodeJoints::jointOf(const aiBone& bone) const {
  return joint_of_bone_.at(bone.mName.C_Str());
}

std::optional<size_t> NodeJoints::carrierOf(const aiNode& node) const {
  for (const aiNode* at = &node; at; at = at->mParent) {
    const auto found = joint_of_node_.find(at);
    if (found != joint_of_node_.end()) return found->second;
  }
  return std::nullopt;
}

/// Transform from the axes of a mesh to those of the earlier meshes, from a common bone or the
/// nearest known one.
Matrix4d NodeJoints::meshFrame(const aiMesh& mesh, const Known& known) const {
  for (unsigned b = 0; b < mesh.mNumBones; ++b)
    if (const auto& place = known[jointOf(*mesh.mBones[b])])
      return *place * matrixOf(mesh.mBones[b]->mOffsetMatrix);
  const size_t joint = jointOf(*mesh.mBones[0]);
  const Matrix4d in_scene = transforms_[joint] * matrixOf(mesh.mBones[0]->mOffsetMatrix);
  for (int above = joints_[joint].parent; above >= 0; above = joints_[size_t(above)].parent)
    if (const auto& place = known[size_t(above)])
      return *place * transforms_[size_t(above)].inverse() * in_scene;
  Matrix4d frame = Matrix4d::Identity();
  if (in_scene.topLeftCorner<3, 3>().determinant() < 0.0) frame(0, 0) = -1.0;
  return frame;
}

void NodeJoints::fillGaps(Known& known) const {
  const auto follow = [&](size_t joint, size_t from) {
    if (known[from] && !known[joint])
      known[joint] = *known[from] * transforms_[from].inverse() * transforms_[joint];
  };
  for (size_t j = joints_.size(); j-- > 0;)
    if (joints_[j].parent >= 0) follow(size_t(joints_[j].parent), j);
  for (size_t j = 0; j < joints_.size(); ++j)
    if (joints_[j].parent >= 0) follow(j, size_t(joints_[j].parent));
}

std::vector<Matrix4d> NodeJoints::bindTransforms() const {
  std::vector<const aiMesh*> meshes(scene_.mMeshes, scene_.mMeshes + scene_.mNumMeshes);
  std::stable_sort(meshes.begin(), meshes.end(),
                   [](const aiMesh* a, const aiMesh* b) { return a->mNumBones > b->mNumBones; });
  Known known(joints_.size());
  for (const aiMesh* mesh : meshes) {
    if (!mesh->HasBones()) break;
    const Matrix4d frame = meshFrame(*mesh, known);
    for (unsigned b = 0; b < mesh->mNumBones; ++b) {
      auto& place = known[jointOf(*mesh->mBones[b])];
      if (!place) place = frame * matrixOf(mesh->mBones[b]->mOffsetMatrix).inverse();
    }
  }
  fillGaps(known);
  std::vector<Matrix4d> transforms;
  for (size_t j = 0; j < joints_.size(); ++j)
    transforms.push_back(known[j] ? *known[j] : transforms_[j]);
  return transforms;
}

}  // namespace markerless_mocap
