#pragma once

#include <cstdint>
#include <vector>

#include "markerless_mocap/segmentation/branch.h"
#include "markerless_mocap/segmentation/eigenmap.h"
#include "markerless_mocap/segmentation/weighted_graph.h"

namespace markerless_mocap {

/// A function on a graph's nodes.
struct Elevation {
  /// Converts: whoever asks several questions about one function sorts its nodes but once.
  Elevation(std::vector<double> heights);

  std::vector<double> height;        ///< of each node
  std::vector<uint32_t> descending;  ///< nodes from the highest to the lowest, equals by number
};

/// Distance of each node from the mean position of the `core` nodes in the embedding, mode k scaled
/// by sqrt(lambda_1 / lambda_k): up to a factor, the square root of the commute time of a random
/// walk. Tips of limbs are its maxima.
std::vector<double> distanceFromCore(const Eigenmap& map, const std::vector<uint32_t>& core);

/// Maxima of a function on a graph's nodes. Lowering a level from the top, components appear at
/// maxima and merge at saddles, the lower maximum ending there; the `count` maxima that persist
/// longest are returned, most persistent first.
std::vector<uint32_t> persistentMaxima(const WeightedGraph& graph, const Elevation& elevation,
                                       int count);

/// The branch of each tip: its component above the saddle with the next tip and above
/// `lowest_share` of the tip's height.
/// \param tips distinct maxima
std::vector<Branch> branchesAtTips(const WeightedGraph& graph, const Elevation& elevation,
                                   const std::vector<uint32_t>& tips, double lowest_share);

/// Lets the branches numbered in `growing` flood downhill to `lowest_share` of their tips' heights
/// over nodes of no branch, each keeping to its own basin.
void growBranches(const WeightedGraph& graph, const Elevation& elevation,
                  const std::vector<int>& growing, double lowest_share,
                  std::vector<Branch>* branches);

}  // namespace markerless_mocap
