#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "markerless_mocap/skeleton/pose_tree_options.h"
#include "skeleton/graph/tree_graph.h"
#include "skeleton/labelling/label_choice.h"

namespace markerless_mocap {

/// Path lengths from an extremity of a candidate tree, metres.
struct ExtremityPathLengths {
  double to_origin;     ///< d_r
  double to_branching;  ///< d_b, to the nearest branching node
};

/// Rank of a node as the origin, where neck, arms and torso meet (Eq. 1 to 4). Of Eq. 2 two forms
/// can be had: q(I_leg, d_r) q(I_leg, d_r - d_b) as it is printed, and with I_torso in the second
/// factor. The text defines I_torso, no printed equation uses it, and d_r - d_b of a leg is the
/// length of the torso; as printed, a leg's rank grows the further the origin is from the legs.
/// \param ends by UnsidedExtremity
/// \param degree number of chains that meet at the node
/// \param longest longest path of the tree, metres
double originRank(const std::array<ExtremityPathLengths, kUnsidedExtremityCount>& extremities,
                  int degree, double longest, const PoseTreeOptions& options);

/// Extremities of the last valid frame, by UnsidedExtremity, world metres.
using PreviousExtremities = std::optional<std::array<Eigen::Vector3d, kUnsidedExtremityCount>>;

/// The published labelling (Algorithm 3). Loops are opened at the edges that are not in the tree of
/// shortest paths.
/// \param last if set, ends get the label of the nearest extremity of the last frame, instead of a
///   label by path lengths
LabelChoice labelByRank(const TreeGraph& graph, const PoseTreeOptions& options,
                        const PreviousExtremities& last);

}  // namespace markerless_mocap
