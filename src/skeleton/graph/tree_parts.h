#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/pose_tree.h"
#include "skeleton/graph/tree_graph.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

/// Part of limb 1 or 2 while left and right are not told apart: the left one stands for 1.
constexpr TreePart partOf(UnsidedExtremity end) {
  constexpr std::array<TreePart, kUnsidedExtremityCount> parts{
      TreePart::kNeck, TreePart::kLeftArm, TreePart::kRightArm, TreePart::kLeftLeg,
      TreePart::kRightLeg};
  return parts[size_t(end)];
}

/// The graph's tree, grown from the head's end instead of the root.
struct RerootedTree {
  std::vector<TreeNode> nodes;                                ///< parents before children
  std::array<int32_t, kUnsidedExtremityCount> extremities{};  ///< nodes, by UnsidedExtremity
  int32_t origin = -1;
};
RerootedTree rerootTree(const TreeGraph& graph, const LabelChoice& choice);

/// Names the parts from the ends upwards (Algorithm 4). Returns whether there is a torso.
bool nameParts(RerootedTree* tree);

/// Rank of the origin of a tree with named parts and a torso, see originRank().
double rerootedRank(const RerootedTree& tree, double longest);

/// Positions from an end upwards as far as its part goes.
std::vector<Eigen::Vector3d> limbPath(const RerootedTree& tree, UnsidedExtremity end);

}  // namespace markerless_mocap
