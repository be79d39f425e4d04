#include "skeleton/graph/tree_parts.h"

#include <algorithm>
#include <utility>

#include "skeleton/labelling/label_ranking.h"

namespace markerless_mocap {
namespace {

/// Names the nodes from `node` upwards until one that is called `stop`; returns that one, or -1
/// above the root.
int32_t nameUpwards(int32_t node, TreePart part, TreePart stop, std::vector<TreeNode>* nodes) {
  while (node >= 0 && (*nodes)[size_t(node)].part != stop) {
    (*nodes)[size_t(node)].part = part;
    node = (*nodes)[size_t(node)].parent;
  }
  return node;
}

}  // namespace

PlantedTree plantTree(const TreeGraph& graph, const LabelChoice& choice) {
  PlantedTree tree;
  std::vector<TreeLinks::Edge> edges;
  const auto isCut = [&](size_t node) {
    return std::any_of(choice.grafts.begin(), choice.grafts.end(),
                       [&](const Graft& graft) { return graft.cut == int32_t(node); });
  };
  for (size_t node = 1; node < graph.size(); ++node)
    if (!isCut(node)) edges.push_back({int32_t(node), graph.parents[node], 0.0});
  for (const Graft& graft : choice.grafts) edges.push_back({graft.from, graft.to, 0.0});
  const TreeLinks links(graph.size(), edges);
  std::vector<int32_t> place(graph.size(), -1), order{std::max(0, choice.ends[0])};
  place[size_t(order[0])] = 0;
  tree.nodes.push_back({graph.positions[size_t(order[0])], -1, TreePart::kNone});
  for (size_t i = 0; i < order.size(); ++i) {
    for (auto link = links.begin(order[i]); link != links.end(order[i]); ++link) {
      if (place[size_t(link->to)] >= 0) continue;
      place[size_t(link->to)] = int32_t(order.size());
      order.push_back(link->to);
      tree.nodes.push_back({graph.positions[size_t(link->to)], int32_t(i), TreePart::kNone});
    }
  }
  const auto placeOf = [&](int32_t node) { return node < 0 ? -1 : place[size_t(node)]; };
  for (size_t i = 0; i < tree.ends.size(); ++i) tree.ends[i] = placeOf(choice.ends[i]);
  tree.origin = placeOf(choice.origin);
  return tree;
}

bool nameParts(PlantedTree* tree) {
  const auto name = [&](LimbEnd end, TreePart stop) {
    return nameUpwards(tree->ends[size_t(end)], partOf(end), stop, &tree->nodes);
  };
  name(LimbEnd::kHand1, TreePart::kNeck);
  const int32_t shoulders = name(LimbEnd::kHand2, partOf(LimbEnd::kHand1));
  nameUpwards(shoulders, TreePart::kNeck, TreePart::kNeck, &tree->nodes);
  name(LimbEnd::kFoot1, TreePart::kNeck);
  const int32_t hips = name(LimbEnd::kFoot2, partOf(LimbEnd::kFoot1));
  nameUpwards(hips, TreePart::kTorso, TreePart::kNeck, &tree->nodes);
  tree->origin = shoulders;
  return hips >= 0 && tree->nodes[size_t(hips)].part == TreePart::kTorso;
}

double plantedRank(const PlantedTree& tree, double longest) {
  const auto wayUp = [&](int32_t node, const auto& stops) {
    double way = 0.0;
    while (!stops(node)) {
      const int32_t up = tree.nodes[size_t(node)].parent;
      if (up < 0) break;
      way += (tree.nodes[size_t(node)].position - tree.nodes[size_t(up)].position).norm();
      node = up;
    }
    return std::make_pair(way, node);
  };
  std::array<EndWays, kLimbEndCount> ways{};
  const double neck = wayUp(tree.origin, [](int32_t) { return false; }).first;
  ways[0] = {neck, neck};
  bool at_origin = true;
  for (size_t i = 1; i < ways.size(); ++i) {
    const auto leavesPart = [&](int32_t node) {
      return tree.nodes[size_t(node)].part != partOf(LimbEnd(i));
    };
    const auto own = wayUp(tree.ends[i], leavesPart);
    // The torso may hang on an arm below the origin: then both go on along the arm.
    const auto to_origin = wayUp(own.second, [&](int32_t node) {
      return node == tree.origin || tree.nodes[size_t(node)].part == TreePart::kNeck;
    });
    ways[i] = {own.first + to_origin.first, own.first};
    at_origin &= to_origin.second == tree.origin;
  }
  return originRank(ways, at_origin ? 4 : 3, longest);
}

std::vector<Eigen::Vector3d> limbPath(const PlantedTree& tree, LimbEnd end) {
  std::vector<Eigen::Vector3d> path;
  for (int32_t node = tree.ends[size_t(end)];
       node >= 0 && tree.nodes[size_t(node)].part == partOf(end);
       node = tree.nodes[size_t(node)].parent)
    path.push_back(tree.nodes[size_t(node)].position);
  return path;
}

}  // namespace markerless_mocap
