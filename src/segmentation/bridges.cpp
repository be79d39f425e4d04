#include "markerless_mocap/segmentation/bridges.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace markerless_mocap {
namespace {

using Contacts = std::pair<std::pair<uint32_t, uint32_t>, std::vector<Edge>>;

/// Touching nodes by pair of components, most contacts first.
std::vector<Contacts> contactsByPair(const NodeGrid& grid, const std::vector<uint32_t>& component) {
  std::map<std::pair<uint32_t, uint32_t>, std::vector<Edge>> found;
  for (uint32_t node = 0; node < component.size(); ++node) {
    for (int step = 14; step < 27; ++step) {  // the half of the 26 neighbours with a higher index
      const int32_t other = grid.neighbor(node, step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
      if (other < 0 || component[other] == component[node]) continue;
      found[std::minmax(component[node], component[other])].push_back({node, uint32_t(other), 1.0});
    }
  }
  std::vector<Contacts> contacts(found.begin(), found.end());
  std::stable_sort(contacts.begin(), contacts.end(), [](const Contacts& a, const Contacts& b) {
    return a.second.size() > b.second.size();
  });
  return contacts;
}

}  // namespace

std::vector<Edge> bridgeEdges(const NodeGrid& grid, const std::vector<uint32_t>& component) {
  std::vector<Edge> bridges;
  if (component.empty()) return bridges;
  const uint32_t count = *std::max_element(component.begin(), component.end()) + 1;
  if (count == 1) return bridges;
  std::vector<uint32_t> joined(count);
  std::iota(joined.begin(), joined.end(), 0u);
  for (const auto& [pair, edges] : contactsByPair(grid, component)) {
    const uint32_t kept = joined[pair.first];
    const uint32_t gone = joined[pair.second];
    if (kept == gone) continue;
    std::replace(joined.begin(), joined.end(), gone, kept);
    bridges.insert(bridges.end(), edges.begin(), edges.end());
  }
  return bridges;
}

}  // namespace markerless_mocap
