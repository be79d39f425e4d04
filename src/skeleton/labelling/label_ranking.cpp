#include "skeleton/labelling/label_ranking.h"

#include <algorithm>
#include <cmath>

#include "skeleton/labelling/label_proportions.h"
#include "skeleton/graph/tree_metric.h"

namespace markerless_mocap {
namespace {

// A step of the voxels that the penalty for a shortened arm was made for: 2 m / 128.
constexpr double kStep = 2.0 / 128.0;

double likeness(double a, double b) {
  return std::max(a, b) > 0.0 ? std::min(a, b) / std::max(a, b) : 0.0;
}

/// Removes ends' chains, the shortest first, until the root and four others are left.
void keepFourLongest(TreeChains* tree) {
  while (true) {
    size_t shortest = tree->chains.size();
    int ends = 0;
    for (size_t i = 0; i < tree->chains.size(); ++i) {
      const TreeChain& chain = tree->chains[i];
      const auto isEnd = [&](int32_t v) { return v != 0 && tree->degrees[size_t(v)] == 1; };
      if (!isEnd(chain.a) && !isEnd(chain.b)) continue;
      ++ends;
      if (shortest == tree->chains.size() || chain.length < tree->chains[shortest].length)
        shortest = i;
    }
    if (ends <= 4) return;
    removeChain(shortest, tree);
  }
}

/// Ends by LimbEnd as their ways to the origin tell: the furthest two are feet, the next two hands.
std::array<int32_t, kLimbEndCount> byWay(const TreeMetric& metric, int32_t origin) {
  std::vector<int32_t> ends = metric.ends();
  std::stable_sort(ends.begin(), ends.end(), [&](int32_t a, int32_t b) {
    return metric.way(a, origin) > metric.way(b, origin);
  });
  return {ends[4], ends[2], ends[3], ends[0], ends[1]};
}

double rankOf(const TreeMetric& metric, const TreeChains& tree, int32_t origin, double longest) {
  std::array<EndWays, kLimbEndCount> ways{};
  const auto ends = byWay(metric, origin);
  for (size_t i = 0; i < ends.size(); ++i)
    ways[i] = {metric.way(ends[i], origin), metric.branch(ends[i])};
  return originRank(ways, tree.degrees[size_t(origin)], longest);
}

/// Each end of the last frame takes the nearest one that is left.
std::array<int32_t, kLimbEndCount> byLast(const std::vector<int32_t>& ends,
                                          const std::array<Eigen::Vector3d, kLimbEndCount>& last,
                                          const TreeGraph& graph, const TreeChains& tree) {
  std::array<int32_t, kLimbEndCount> out{};
  std::vector<int32_t> left = ends;
  for (size_t i = 0; i < out.size(); ++i) {
    const auto away = [&](int32_t v) {
      return (graph.positions[size_t(tree.vertices[size_t(v)])] - last[i]).squaredNorm();
    };
    const auto nearest = std::min_element(left.begin(), left.end(),
                                          [&](int32_t a, int32_t b) { return away(a) < away(b); });
    out[i] = *nearest;
    left.erase(nearest);
  }
  return out;
}

}  // namespace

double originRank(const std::array<EndWays, kLimbEndCount>& ends, int degree, double longest) {
  const auto at = [&](LimbEnd end) { return ends[size_t(end)]; };
  double rank = std::exp(-double((degree - 4) * (degree - 4)) / 3.0);
  for (const LimbEnd foot : {LimbEnd::kFoot1, LimbEnd::kFoot2}) {
    rank *= likeness(label_ratio::kLeg * longest, at(foot).to_branching) *
            likeness(label_ratio::kTorso * longest, at(foot).to_origin - at(foot).to_branching);
  }
  const auto shortened = [](const EndWays& w) {
    return 1.0 / (1.0 + (w.to_origin - w.to_branching) / kStep);
  };
  for (const LimbEnd hand : {LimbEnd::kHand1, LimbEnd::kHand2})
    rank *= likeness(label_ratio::kArm * longest, at(hand).to_origin) * shortened(at(hand));
  rank *= likeness(label_ratio::kNeck * longest, at(LimbEnd::kHead).to_origin) *
          shortened(at(LimbEnd::kHead));
  return rank;
}

LabelChoice labelByRank(const TreeGraph& graph, double prune_ratio, const LastEnds& last) {
  LabelChoice choice;
  TreeChains tree = makeChains(graph);
  choice.longest = longestWay(graph);
  pruneChains(prune_ratio * choice.longest, &tree);
  keepFourLongest(&tree);
  const TreeMetric metric(graph, tree);
  if (metric.ends().size() != size_t(kLimbEndCount)) {
    choice.reason = "the skeleton has " + std::to_string(metric.ends().size()) +
                    " ends that are no spurs, a body has five";
    return choice;
  }
  int32_t origin = -1;
  for (const int32_t vertex : metric.branchings()) {
    const double rank = rankOf(metric, tree, vertex, choice.longest);
    if (origin >= 0 && rank <= choice.rank) continue;
    origin = vertex;
    choice.rank = rank;
  }
  const auto ends = last ? byLast(metric.ends(), *last, graph, tree) : byWay(metric, origin);
  for (size_t i = 0; i < ends.size(); ++i) choice.ends[i] = tree.vertices[size_t(ends[i])];
  choice.origin = tree.vertices[size_t(origin)];
  choice.status = TreeStatus::kOk;
  return choice;
}

}  // namespace markerless_mocap
