#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/eigenmap.h"

namespace markerless_mocap {

/// Which nodes are neighbours, in compressed rows as WeightedGraph has them.
struct Adjacency {
  std::vector<uint32_t> row_start;
  std::vector<uint32_t> neighbor;
};

/// Distance of each node from the mean position of the `core` nodes in the embedding, mode k scaled
/// by sqrt(lambda_1 / lambda_k): up to a factor, the square root of the commute time of a random
/// walk. Tips of limbs are its maxima.
std::vector<double> distanceFromCore(const Eigenmap& map, const std::vector<uint32_t>& core);

/// Maxima of a function on a graph's nodes. Lowering a level from the top, components appear at
/// maxima and merge at saddles, the lower maximum ending there; the `count` maxima that persist
/// longest are returned, most persistent first.
/// \param height of each node
std::vector<uint32_t> persistentMaxima(const Adjacency& graph, const std::vector<double>& height,
                                       int count);

}  // namespace markerless_mocap
