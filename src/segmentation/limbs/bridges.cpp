#include "segmentation/limbs/bridges.h"

#include <algorithm>

#include "numerics/disjoint_sets.h"

namespace markerless_mocap {

std::vector<uint32_t> faceComponents(const NodeGrid& grid) {
  std::vector<uint32_t> parent(grid.nodeCount());
  for (uint32_t node = 0; node < parent.size(); ++node) {
    parent[node] = node;
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t before = grid.neighbor(node, -(axis == 0), -(axis == 1), -(axis == 2));
      if (before >= 0) joinSets(&parent, uint32_t(before), node);
    }
  }
  std::vector<uint32_t> component;
  uint32_t count = 0;
  component.reserve(parent.size());
  for (uint32_t node = 0; node < parent.size(); ++node)
    component.push_back(parent[node] == node ? count++ : component[parent[node]]);
  return component;
}

std::vector<Edge> bridgeEdges(const NodeGrid& grid, const std::vector<uint32_t>& component) {
  std::vector<Edge> bridges;
  const uint32_t largest = mostFrequent(component);  // each bridge has one end outside it
  for (uint32_t node = 0; node < component.size(); ++node) {
    if (component[node] == largest) continue;
    for (int step = 0; step < 27; ++step) {
      const int32_t found = grid.neighbor(node, step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
      if (found < 0 || component[found] == component[node]) continue;
      const auto other = uint32_t(found);
      if (component[other] != largest && other < node) continue;  // added from the other end
      bridges.push_back({std::min(node, other), std::max(node, other), 1.0});
    }
  }
  std::sort(bridges.begin(), bridges.end(), [](const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  return bridges;
}

}  // namespace markerless_mocap
