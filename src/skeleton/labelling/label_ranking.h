#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "skeleton/graph/tree_graph.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

/// Ways of an end of a candidate tree, metres.
struct ExtremityPathLengths {
  double to_origin;     ///< d_r
  double to_branching;  ///< d_b, to the nearest branching node
};

/// Rank of a node as the place where neck, arms and torso meet (Eq. 1 to 4, but the second factor
/// of Eq. 2 compares the torso: q(I_leg, d_b) q(I_torso, d_r - d_b); so the ideal tree ranks 1).
/// \param ends by UnsidedExtremity \param degree chains that meet at the node \param longest path
/// of the tree
double originRank(const std::array<ExtremityPathLengths, kUnsidedExtremityCount>& extremities,
                  int degree, double longest);

/// Where the ends of the last valid frame were, by UnsidedExtremity; world metres.
using PreviousExtremities = std::optional<std::array<Eigen::Vector3d, kUnsidedExtremityCount>>;

/// The published labelling (Algorithm 3): loops are open where the shortest paths leave them.
/// \param prune_ratio branches shorter than this share of the longest path are spurs
/// \param last if set, ends are named by the nearest one of the last frame, not by their ways
LabelChoice labelByRank(const TreeGraph& graph, double prune_ratio,
                        const PreviousExtremities& last);

}  // namespace markerless_mocap
