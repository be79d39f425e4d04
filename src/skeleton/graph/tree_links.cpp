#include "skeleton/graph/tree_graph.h"

namespace markerless_mocap {

TreeLinks::TreeLinks(size_t nodes, const std::vector<Edge>& edges)
    : first_(nodes + 1, 0), links_(2 * edges.size()) {
  for (const Edge& edge : edges) {
    ++first_[size_t(edge.a) + 1];
    ++first_[size_t(edge.b) + 1];
  }
  for (size_t node = 0; node < nodes; ++node) first_[node + 1] += first_[node];
  std::vector<int32_t> next(first_.begin(), first_.end() - 1);
  for (const Edge& edge : edges) {
    links_[size_t(next[size_t(edge.a)]++)] = {edge.b, edge.length};
    links_[size_t(next[size_t(edge.b)]++)] = {edge.a, edge.length};
  }
}

}  // namespace markerless_mocap
