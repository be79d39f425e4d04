#include "skeleton/graph/tree_components.h"

#include <algorithm>
#include <numeric>

#include "numerics/disjoint_sets.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxComponents = 8;  // the others are specks

/// Nodes of each of the largest components, the largest first.
std::vector<std::vector<int32_t>> largestComponents(size_t nodes,
                                                    const std::vector<TreeLinks::Edge>& edges) {
  std::vector<uint32_t> parents(nodes);
  std::iota(parents.begin(), parents.end(), 0u);
  for (const TreeLinks::Edge& edge : edges) joinSets(&parents, uint32_t(edge.a), uint32_t(edge.b));
  std::vector<int32_t> number(nodes, -1);
  std::vector<std::vector<int32_t>> components;
  for (size_t node = 0; node < nodes; ++node) {
    int32_t& n = number[rootOf(&parents, uint32_t(node))];
    if (n < 0) {
      n = int32_t(components.size());
      components.emplace_back();
    }
    components[size_t(n)].push_back(int32_t(node));
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  if (components.size() > kMaxComponents) components.resize(kMaxComponents);
  return components;
}

}  // namespace

std::vector<bool> joinComponents(const std::vector<Eigen::Vector3d>& positions, double gap,
                                 std::vector<TreeLinks::Edge>* edges) {
  auto components = largestComponents(positions.size(), *edges);
  std::vector<bool> kept(positions.size(), false);
  if (components.empty()) return kept;
  std::vector<int32_t> joined = std::move(components.front());
  components.erase(components.begin());
  while (!components.empty()) {
    TreeLinks::Edge nearest{-1, -1, gap};
    size_t which = 0;
    for (size_t c = 0; c < components.size(); ++c) {
      for (const int32_t a : components[c]) {
        for (const int32_t b : joined) {
          const double distance = (positions[size_t(a)] - positions[size_t(b)]).norm();
          if (distance > nearest.length) continue;
          nearest = {a, b, distance};
          which = c;
        }
      }
    }
    if (nearest.a < 0) break;
    edges->push_back(nearest);
    joined.insert(joined.end(), components[which].begin(), components[which].end());
    components.erase(components.begin() + long(which));
  }
  for (const int32_t node : joined) kept[size_t(node)] = true;
  return kept;
}

}  // namespace markerless_mocap
