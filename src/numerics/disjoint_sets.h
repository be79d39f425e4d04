#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Union-find: sets of numbers as trees of parents; a root is its own parent.
inline uint32_t rootOf(std::vector<uint32_t>* parents, uint32_t number) {
  std::vector<uint32_t>& parent = *parents;
  while (parent[number] != number) {
    parent[number] = parent[parent[number]];
    number = parent[number];
  }
  return number;
}

/// Joins two sets; the smaller root stays a root.
inline void joinSets(std::vector<uint32_t>* parents, uint32_t one, uint32_t other) {
  const uint32_t a = rootOf(parents, one);
  const uint32_t b = rootOf(parents, other);
  (*parents)[std::max(a, b)] = std::min(a, b);
}

}  // namespace markerless_mocap
