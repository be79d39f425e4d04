#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/eigenmap.h"

namespace markerless_mocap {

/// Neighbours of nodes in compressed rows, as in WeightedGraph.
struct Adjacency {
  std::vector<uint32_t> row_start;
  std::vector<uint32_t> neighbor;
};

/// Distance of each node from the mean position of the `core` nodes in the embedding, with mode k
/// scaled by sqrt(lambda_1 / lambda_k). Up to a factor this is the square root of the commute time
/// of a random walk. Its maxima are the extremities of limbs.
std::vector<double> distanceFromCore(const Eigenmap& map, const std::vector<uint32_t>& core);

/// The most persistent maxima of a function on a graph's nodes. As a level is lowered from the top,
/// components appear at maxima and merge at saddles, where the lower maximum ends. The `count`
/// maxima with the largest difference between both levels are returned, the most persistent first.
/// \param height value at each node
std::vector<uint32_t> persistentMaxima(const Adjacency& graph, const std::vector<double>& height,
                                       int count);

}  // namespace markerless_mocap
