#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "motion/human_pose.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Triangle mesh with a colour per vertex. Triangles are counter-clockwise seen from outside.
struct ColoredMesh {
  std::vector<Eigen::Vector3f> vertices;  ///< metres
  std::vector<Eigen::Vector3f> colors;    ///< per vertex: red, green, blue, 0 to 1
  std::vector<std::array<int, 3>> triangles;
};

/// Skinning weights of a vertex: up to four bones; weights sum to 1, unused ones are 0.
struct VertexWeights {
  std::array<Bone, 4> bones{};
  std::array<float, 4> weights{};
};

/// A dressed person as a skinned mesh, in the T-pose of HumanPose.
struct Character {
  HumanSkeleton skeleton;
  ColoredMesh mesh;
  std::vector<VertexWeights> weights;  ///< per vertex

  /// Computes the mesh's vertices in the world, metres, by dual quaternion skinning, so that bent
  /// and twisted limbs keep their girth. The twist of forearm, upper arm and thigh is distributed
  /// along them.
  /// \param vertices output, resized
  void pose(const HumanPose& pose, std::vector<Eigen::Vector3f>& vertices) const;
};

}  // namespace markerless_mocap
