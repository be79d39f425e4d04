#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/skeleton/pose_tree_options.h"
#include "skeleton/graph/tree_graph.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

/// Part of an extremity. As sides are not known yet, the left limb stands for limb 1.
constexpr TreePart partOf(UnsidedExtremity end) {
  constexpr std::array<TreePart, kUnsidedExtremityCount> parts{
      TreePart::kNeck, TreePart::kLeftArm, TreePart::kRightArm, TreePart::kLeftLeg,
      TreePart::kRightLeg};
  return parts[size_t(end)];
}

/// The graph's tree with the head's extremity as its root.
struct RerootedTree {
  std::vector<TreeNode> nodes;  ///< parents before children
  /// Nodes of the extremities, by UnsidedExtremity.
  std::array<int32_t, kUnsidedExtremityCount> extremities{};
  int32_t origin = -1;
};
RerootedTree rerootTree(const TreeGraph& graph, const LabelChoice& choice);

/// Labels the parts from the extremities upwards (Algorithm 4). Returns whether there is a torso.
bool nameParts(RerootedTree* tree);

/// Rank of the origin of a tree with labelled parts and a torso, see originRank().
double rerootedRank(const RerootedTree& tree, double longest, const PoseTreeOptions& options);

/// Positions of the nodes from an extremity upwards to the end of its part.
std::vector<Eigen::Vector3d> limbPath(const RerootedTree& tree, UnsidedExtremity end);

}  // namespace markerless_mocap
