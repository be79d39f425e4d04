#include "tools/common/tree_labels.h"

#include <vector>

namespace markerless_mocap {
namespace {

/// Nodes of the part that an extremity belongs to, from the extremity towards the root.
Eigen::Matrix3Xd limbOf(const PoseTree& tree, int32_t end) {
  std::vector<Eigen::Vector3d> path;
  const TreePart part = tree.nodes[size_t(end)].part;
  for (int32_t at = end; at >= 0 && tree.nodes[size_t(at)].part == part;
       at = tree.nodes[size_t(at)].parent)
    path.push_back(tree.nodes[size_t(at)].position);
  return Eigen::Map<const Eigen::Matrix3Xd>(path.front().data(), 3, Eigen::Index(path.size()));
}

}  // namespace

LabelledExtremities labelsOf(const PoseTree& tree) {
  LabelledExtremities labels;
  labels.valid = tree.valid();
  labels.validity = tree.validity;
  for (int i = 0; i < kExtremityCount; ++i) {
    if (tree.extremities[size_t(i)].node < 0) continue;
    labels.positions.col(i) = tree.extremities[size_t(i)].position;
    labels.limbs[size_t(i)] = limbOf(tree, tree.extremities[size_t(i)].node);
  }
  return labels;
}

}  // namespace markerless_mocap
