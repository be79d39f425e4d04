#include "calibration/start/spanning_tree.h"

#include <algorithm>
#include <numeric>

namespace markerless_mocap {

std::vector<TreeStep> spanningTree(size_t nodes, const std::vector<Link>& links, size_t root) {
  std::vector<bool> reached(nodes, false);
  reached[root] = true;
  std::vector<TreeStep> steps;
  for (;;) {
    const Link* best = nullptr;
    for (const Link& link : links)
      if (reached[link.a] != reached[link.b] && (!best || link.weight > best->weight)) best = &link;
    if (!best) return steps;
    const bool forward = reached[best->a];
    steps.push_back(
        {forward ? best->a : best->b, forward ? best->b : best->a, size_t(best - links.data())});
    reached[steps.back().child] = true;
  }
}

std::vector<size_t> groupsOf(size_t nodes, const std::vector<Link>& links) {
  std::vector<size_t> groups(nodes);
  std::iota(groups.begin(), groups.end(), 0);
  for (const Link& link : links)
    if (groups[link.a] != groups[link.b])
      std::replace(groups.begin(), groups.end(), groups[link.b], size_t(groups[link.a]));
  return groups;
}

size_t strongestNode(const std::vector<Link>& links, const std::vector<size_t>& groups,
                     size_t group) {
  std::vector<double> sums(groups.size(), 0.0);
  for (const Link& link : links) {
    sums[link.a] += link.weight;
    sums[link.b] += link.weight;
  }
  size_t best = size_t(std::find(groups.begin(), groups.end(), group) - groups.begin());
  for (size_t i = 0; i < groups.size(); ++i)
    if (groups[i] == group && sums[i] > sums[best]) best = i;
  return best;
}

}  // namespace markerless_mocap
