#include "markerless_mocap/character/character.h"

namespace markerless_mocap {

void Character::pose(const HumanPose& pose, std::vector<Eigen::Vector3f>& vertices) const {
  const PerBone<Eigen::Vector3d> heads = jointPositions(skeleton, pose);
  PerBone<Eigen::Matrix<float, 3, 4>> moves;
  for (size_t b = 0; b < size_t(kBoneCount); ++b) {
    const Eigen::Matrix3d R = pose.R_world_bone[b].toRotationMatrix();
    moves[b].leftCols<3>() = R.cast<float>();
    moves[b].col(3) = (heads[b] - R * skeleton.head[b]).cast<float>();
  }
  vertices.resize(mesh.vertices.size());
  for (size_t v = 0; v < vertices.size(); ++v) {
    Eigen::Matrix<float, 3, 4> move = Eigen::Matrix<float, 3, 4>::Zero();
    for (size_t k = 0; k < 4; ++k)
      move += weights[v].weights[k] * moves[size_t(weights[v].bones[k])];
    vertices[v] = move.leftCols<3>() * mesh.vertices[v] + move.col(3);
  }
}

}  // namespace markerless_mocap
