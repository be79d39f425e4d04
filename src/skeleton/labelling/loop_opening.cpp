#include "skeleton/labelling/loop_opening.h"

#include <algorithm>

#include "skeleton/labelling/label_proportions.h"

namespace markerless_mocap {
namespace {

/// Fraction of the longest path: a hand this far below the shoulders hangs.
constexpr double kLow = 0.12;
/// Fraction of the longest path: a hand's extremity is further from the trunk than this.
constexpr double kInside = 0.03;

void markUp(const TreeGraph& graph, int32_t from, std::vector<bool>* marks) {
  for (int32_t at = from; at >= 0; at = graph.parents[size_t(at)]) (*marks)[size_t(at)] = true;
}

/// The nodes on the paths from the head's extremity to those of the feet.
std::vector<bool> trunkOf(const TreeGraph& graph, const LabelChoice& choice) {
  std::vector<bool> trunk(graph.size(), false);
  for (const UnsidedExtremity foot : {UnsidedExtremity::kFoot1, UnsidedExtremity::kFoot2}) {
    int32_t a = choice.extremities[size_t(UnsidedExtremity::kHead)],
            b = choice.extremities[size_t(foot)];
    while (a != b) {  // parents have lower numbers
      int32_t& lower = a > b ? a : b;
      trunk[size_t(lower)] = true;
      lower = graph.parents[size_t(lower)];
    }
    trunk[size_t(a)] = true;
  }
  return trunk;
}

/// Path length from a node towards the root until the trunk, metres.
double pathLengthToTrunk(const TreeGraph& graph, const std::vector<bool>& trunk, int32_t node) {
  double path_length = 0.0;
  for (; node > 0 && !trunk[size_t(node)]; node = graph.parents[size_t(node)])
    path_length += graph.step(node);
  return path_length;
}

int32_t trunkAbove(const TreeGraph& graph, const std::vector<bool>& trunk, int32_t node) {
  while (node > 0 && !trunk[size_t(node)]) node = graph.parents[size_t(node)];
  return node;
}

}  // namespace

void openLoopsAtHands(const TreeGraph& graph, LabelChoice* choice) {
  const std::vector<bool> trunk = trunkOf(graph, *choice);
  const std::vector<double> from_head =
      treePathLengthsFrom(graph, choice->extremities[size_t(UnsidedExtremity::kHead)]);
  for (const UnsidedExtremity hand : {UnsidedExtremity::kHand1, UnsidedExtremity::kHand2}) {
    int32_t& end = choice->extremities[size_t(hand)];
    const auto edge =
        std::find_if(graph.loop_edges.begin(), graph.loop_edges.end(),
                     [&](const TreeLinks::Edge& e) { return e.a == end || e.b == end; });
    if (edge == graph.loop_edges.end()) continue;
    int32_t arm = edge->a, other = edge->b;
    if (pathLengthToTrunk(graph, trunk, arm) < pathLengthToTrunk(graph, trunk, other))
      std::swap(arm, other);
    const double below = from_head[size_t(trunkAbove(graph, trunk, other))] -
                         from_head[size_t(trunkAbove(graph, trunk, arm))];
    if (below < kLow * choice->longest) continue;
    std::vector<bool> taken = trunk;
    markUp(graph, arm, &taken);
    markUp(graph,
           choice->extremities[size_t(hand == UnsidedExtremity::kHand1 ? UnsidedExtremity::kHand2
                                                                       : UnsidedExtremity::kHand1)],
           &taken);
    if (taken[size_t(other)] || !choice->edge_exchanges.empty()) continue;
    choice->closed[size_t(hand)] = true;
    end = arm;
    double left = (label_ratio::kNeck + label_ratio::kArm) * choice->longest -
                  from_head[size_t(arm)] - edge->length;
    for (int32_t at = other;
         left > 0.0 && pathLengthToTrunk(graph, taken, at) > kInside * choice->longest;
         at = graph.parents[size_t(at)]) {
      left -= graph.step(at);
      end = at;
    }
    if (end != arm) choice->edge_exchanges.push_back({end, arm, other});
  }
}

}  // namespace markerless_mocap
