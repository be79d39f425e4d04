#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "skeleton/graph/tree_graph.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

/// Path lengths from an extremity of a candidate tree, metres.
struct ExtremityPathLengths {
  double to_origin;     ///< d_r
  double to_branching;  ///< d_b, to the nearest branching node
};

/// Rank of a node as the origin, where neck, arms and torso meet (Eq. 1 to 4). Unlike in the paper,
/// the second factor of Eq. 2 compares the torso, q(I_leg, d_b) q(I_torso, d_r - d_b), so that the
/// ideal tree has rank 1.
/// \param ends by UnsidedExtremity
/// \param degree number of chains that meet at the node
/// \param longest longest path of the tree, metres
double originRank(const std::array<ExtremityPathLengths, kUnsidedExtremityCount>& extremities,
                  int degree, double longest);

/// Extremities of the last valid frame, by UnsidedExtremity, world metres.
using PreviousExtremities = std::optional<std::array<Eigen::Vector3d, kUnsidedExtremityCount>>;

/// The published labelling (Algorithm 3). Loops are opened at the edges that are not in the tree of
/// shortest paths.
/// \param prune_ratio branches shorter than this fraction of the longest path are spurs
/// \param last if set, ends get the label of the nearest extremity of the last frame, instead of a
///   label by path lengths
LabelChoice labelByRank(const TreeGraph& graph, double prune_ratio,
                        const PreviousExtremities& last);

}  // namespace markerless_mocap
