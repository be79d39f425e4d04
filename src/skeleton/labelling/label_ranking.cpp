#include "skeleton/labelling/label_ranking.h"

#include <algorithm>
#include <cmath>

#include "skeleton/graph/tree_metric.h"

namespace markerless_mocap {
namespace {

double lengthSimilarity(double a, double b) {
  return std::max(a, b) > 0.0 ? std::min(a, b) / std::max(a, b) : 0.0;
}

/// Removes the chains of ends, the shortest first, until the root and four other ends are left.
void keepFourLongest(TreeChains* tree) {
  while (true) {
    size_t shortest = tree->chains.size();
    int extremities = 0;
    for (size_t i = 0; i < tree->chains.size(); ++i) {
      const TreeChain& chain = tree->chains[i];
      const auto isEnd = [&](int32_t v) { return v != 0 && tree->degrees[size_t(v)] == 1; };
      if (!isEnd(chain.a) && !isEnd(chain.b)) continue;
      ++extremities;
      if (shortest == tree->chains.size() || chain.length < tree->chains[shortest].length)
        shortest = i;
    }
    if (extremities <= 4) return;
    removeChain(shortest, tree);
  }
}

/// Ends by UnsidedExtremity, from their path lengths to the origin: the two longest lead to the
/// feet, the next two to the hands.
std::array<int32_t, kUnsidedExtremityCount> byPathLength(const TreeMetric& metric, int32_t origin) {
  std::vector<int32_t> extremities = metric.ends();
  std::stable_sort(extremities.begin(), extremities.end(), [&](int32_t a, int32_t b) {
    return metric.pathLength(a, origin) > metric.pathLength(b, origin);
  });
  return {extremities[4], extremities[2], extremities[3], extremities[0], extremities[1]};
}

double rankOf(const TreeMetric& metric, const TreeChains& tree, int32_t origin, double longest,
              const PoseTreeOptions& options) {
  std::array<ExtremityPathLengths, kUnsidedExtremityCount> path_lengths{};
  const auto extremities = byPathLength(metric, origin);
  for (size_t i = 0; i < extremities.size(); ++i)
    path_lengths[i] = {metric.pathLength(extremities[i], origin), metric.branch(extremities[i])};
  return originRank(path_lengths, tree.degrees[size_t(origin)], longest, options);
}

/// Each extremity of the last frame is matched to the nearest end that is left.
std::array<int32_t, kUnsidedExtremityCount> byPreviousFrame(
    const std::vector<int32_t>& extremities,
    const std::array<Eigen::Vector3d, kUnsidedExtremityCount>& last, const TreeGraph& graph,
    const TreeChains& tree) {
  std::array<int32_t, kUnsidedExtremityCount> out{};
  std::vector<int32_t> left = extremities;
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

double originRank(const std::array<ExtremityPathLengths, kUnsidedExtremityCount>& extremities,
                  int degree, double longest, const PoseTreeOptions& options) {
  const LimbRatios& ideal = options.limb_ratios;
  const auto at = [&](UnsidedExtremity end) { return extremities[size_t(end)]; };
  double rank = std::exp(-double((degree - 4) * (degree - 4)) / options.degree_spread);
  const double beyond = options.leg_rank == "printed" ? ideal.leg() : ideal.torso();
  for (const UnsidedExtremity foot : {UnsidedExtremity::kFoot1, UnsidedExtremity::kFoot2}) {
    rank *= lengthSimilarity(ideal.leg() * longest, at(foot).to_origin) *
            lengthSimilarity(beyond * longest, at(foot).to_origin - at(foot).to_branching);
  }
  const auto shortened = [&](const ExtremityPathLengths& w) {
    return 1.0 / (1.0 + (w.to_origin - w.to_branching) / options.shortening_unit);
  };
  for (const UnsidedExtremity hand : {UnsidedExtremity::kHand1, UnsidedExtremity::kHand2})
    rank *= lengthSimilarity(ideal.arm() * longest, at(hand).to_origin) * shortened(at(hand));
  rank *= lengthSimilarity(ideal.neck() * longest, at(UnsidedExtremity::kHead).to_origin) *
          shortened(at(UnsidedExtremity::kHead));
  return rank;
}

LabelChoice labelByRank(const TreeGraph& graph, const PoseTreeOptions& options,
                        const PreviousExtremities& last) {
  LabelChoice choice;
  TreeChains tree = makeChains(graph);
  choice.longest = longestPathLength(graph);
  pruneChains(options.prune_ratio * choice.longest, &tree);
  keepFourLongest(&tree);
  const TreeMetric metric(graph, tree);
  if (metric.ends().size() != size_t(kUnsidedExtremityCount)) {
    choice.reason = "the skeleton has " + std::to_string(metric.ends().size()) +
                    " extremities, a body has five";
    return choice;
  }
  int32_t origin = -1;
  for (const int32_t vertex : metric.branchings()) {
    const double rank = rankOf(metric, tree, vertex, choice.longest, options);
    if (origin >= 0 && rank <= choice.rank) continue;
    origin = vertex;
    choice.rank = rank;
  }
  const auto extremities =
      last ? byPreviousFrame(metric.ends(), *last, graph, tree) : byPathLength(metric, origin);
  for (size_t i = 0; i < extremities.size(); ++i)
    choice.extremities[i] = tree.vertices[size_t(extremities[i])];
  choice.origin = tree.vertices[size_t(origin)];
  choice.status = TreeStatus::kOk;
  return choice;
}

}  // namespace markerless_mocap
