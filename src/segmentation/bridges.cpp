#include "markerless_mocap/segmentation/bridges.h"

namespace markerless_mocap {

std::vector<Edge> bridgeEdges(const NodeGrid& grid, const std::vector<uint32_t>& component) {
  std::vector<Edge> bridges;
  for (uint32_t node = 0; node < component.size(); ++node) {
    for (int step = 14; step < 27; ++step) {  // the half of the 26 neighbours with a higher index
      const int32_t other = grid.neighbor(node, step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
      if (other < 0 || component[other] == component[node]) continue;
      bridges.push_back({node, uint32_t(other), 1.0});
    }
  }
  return bridges;
}

}  // namespace markerless_mocap
