#pragma once

#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// A limb-like piece of a voxel graph, not yet named.
struct Branch {
  uint32_t extremity = 0;       ///< node furthest out
  std::vector<uint32_t> nodes;  ///< ascending; holds the tip
};

}  // namespace markerless_mocap
