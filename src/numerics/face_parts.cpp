#include "numerics/face_parts.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "numerics/disjoint_sets.h"

namespace markerless_mocap {
namespace {

uint64_t keyOf(const Eigen::Vector3i& cell) {
  // One more than the cell, so that the cell before the first has a key of its own.
  const auto part = [&](int axis) { return uint64_t(cell[axis] + 1); };
  return part(0) | part(1) << 21 | part(2) << 42;
}

}  // namespace

std::vector<size_t> largestFacePart(const std::vector<Eigen::Vector3i>& cells) {
  std::unordered_map<uint64_t, uint32_t> places;
  for (const Eigen::Vector3i& cell : cells) places.emplace(keyOf(cell), uint32_t(places.size()));
  std::vector<uint32_t> parents(cells.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (size_t i = 0; i < cells.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const auto before = places.find(keyOf(cells[i] - Eigen::Vector3i::Unit(axis)));
      if (before != places.end()) joinSets(&parents, before->second, uint32_t(i));
    }
  std::vector<size_t> sizes(cells.size(), 0);
  for (size_t i = 0; i < cells.size(); ++i) ++sizes[rootOf(&parents, uint32_t(i))];
  const auto largest = uint32_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::vector<size_t> part;
  for (size_t i = 0; i < cells.size(); ++i)
    if (rootOf(&parents, uint32_t(i)) == largest) part.push_back(i);
  return part;
}

}  // namespace markerless_mocap
