#pragma once

#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// A limb-like part of a voxel graph, before a body part is assigned.
struct Branch {
  uint32_t extremity = 0;       ///< node furthest from the core
  std::vector<uint32_t> nodes;  ///< ascending; contains the extremity
};

}  // namespace markerless_mocap
