#include "markerless_mocap/segmentation/bridges.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

uint32_t largestOf(const std::vector<uint32_t>& component) {
  std::vector<uint32_t> sizes;
  for (const uint32_t c : component) {
    if (c >= sizes.size()) sizes.resize(c + 1, 0);
    ++sizes[c];
  }
  return uint32_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
}

}  // namespace

std::vector<Edge> bridgeEdges(const NodeGrid& grid, const std::vector<uint32_t>& component) {
  std::vector<Edge> bridges;
  const uint32_t largest = largestOf(component);  // each bridge has an end outside it
  for (uint32_t node = 0; node < component.size(); ++node) {
    if (component[node] == largest) continue;
    for (int step = 0; step < 27; ++step) {
      const int32_t found = grid.neighbor(node, step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
      if (found < 0 || component[found] == component[node]) continue;
      const auto other = uint32_t(found);
      if (component[other] != largest && other < node) continue;  // seen from there
      bridges.push_back({std::min(node, other), std::max(node, other), 1.0});
    }
  }
  std::sort(bridges.begin(), bridges.end(), [](const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  return bridges;
}

}  // namespace markerless_mocap
