#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "motion/human_pose.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Triangles with a colour at each vertex. Counter-clockwise seen from outside.
struct ColoredMesh {
  std::vector<Eigen::Vector3f> vertices;  ///< metres
  std::vector<Eigen::Vector3f> colors;    ///< of each vertex, red green blue, 0 to 1
  std::vector<std::array<int, 3>> triangles;
};

/// Up to four bones that carry a vertex; weights sum to 1, unused ones are 0.
struct VertexWeights {
  std::array<Bone, 4> bones{};
  std::array<float, 4> weights{};
};

/// A dressed person as a skinned mesh, in the T-pose of HumanPose.
struct Character {
  HumanSkeleton skeleton;
  ColoredMesh mesh;
  std::vector<VertexWeights> weights;  ///< of each vertex

  /// The mesh's vertices in the world: dual quaternion skinning, so that bent and twisted limbs
  /// keep their girth, with the twist of forearm, upper arm and thigh spread along them. Writes
  /// into `vertices` (resized).
  void pose(const HumanPose& pose, std::vector<Eigen::Vector3f>& vertices) const;
};

}  // namespace markerless_mocap
