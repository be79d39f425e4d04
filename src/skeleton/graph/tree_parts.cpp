#include "skeleton/graph/tree_parts.h"

#include <algorithm>
#include <utility>

#include "skeleton/labelling/label_ranking.h"

namespace markerless_mocap {
namespace {

/// Labels the nodes from `node` upwards until one with the label `stop`; returns that node, or -1
/// above the root.
int32_t nameUpwards(int32_t node, TreePart part, TreePart stop, std::vector<TreeNode>* nodes) {
  while (node >= 0 && (*nodes)[size_t(node)].part != stop) {
    (*nodes)[size_t(node)].part = part;
    node = (*nodes)[size_t(node)].parent;
  }
  return node;
}

}  // namespace

RerootedTree rerootTree(const TreeGraph& graph, const LabelChoice& choice) {
  RerootedTree tree;
  std::vector<TreeLinks::Edge> edges;
  const auto isCut = [&](size_t node) {
    return std::any_of(choice.edge_exchanges.begin(), choice.edge_exchanges.end(),
                       [&](const EdgeExchange& exchange) { return exchange.cut == int32_t(node); });
  };
  for (size_t node = 1; node < graph.size(); ++node)
    if (!isCut(node)) edges.push_back({int32_t(node), graph.parents[node], 0.0});
  for (const EdgeExchange& exchange : choice.edge_exchanges)
    edges.push_back({exchange.from, exchange.to, 0.0});
  const TreeLinks links(graph.size(), edges);
  std::vector<int32_t> place(graph.size(), -1), order{std::max(0, choice.extremities[0])};
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
  for (size_t i = 0; i < tree.extremities.size(); ++i)
    tree.extremities[i] = placeOf(choice.extremities[i]);
  tree.origin = placeOf(choice.origin);
  return tree;
}

bool nameParts(RerootedTree* tree) {
  const auto name = [&](UnsidedExtremity end, TreePart stop) {
    return nameUpwards(tree->extremities[size_t(end)], partOf(end), stop, &tree->nodes);
  };
  name(UnsidedExtremity::kHand1, TreePart::kNeck);
  const int32_t shoulders = name(UnsidedExtremity::kHand2, partOf(UnsidedExtremity::kHand1));
  nameUpwards(shoulders, TreePart::kNeck, TreePart::kNeck, &tree->nodes);
  name(UnsidedExtremity::kFoot1, TreePart::kNeck);
  const int32_t hips = name(UnsidedExtremity::kFoot2, partOf(UnsidedExtremity::kFoot1));
  nameUpwards(hips, TreePart::kTorso, TreePart::kNeck, &tree->nodes);
  tree->origin = shoulders;
  return hips >= 0 && tree->nodes[size_t(hips)].part == TreePart::kTorso;
}

double rerootedRank(const RerootedTree& tree, double longest, const PoseTreeOptions& options) {
  const auto pathLengthUp = [&](int32_t node, const auto& stops) {
    double path_length = 0.0;
    while (!stops(node)) {
      const int32_t up = tree.nodes[size_t(node)].parent;
      if (up < 0) break;
      path_length += (tree.nodes[size_t(node)].position - tree.nodes[size_t(up)].position).norm();
      node = up;
    }
    return std::make_pair(path_length, node);
  };
  std::array<ExtremityPathLengths, kUnsidedExtremityCount> path_lengths{};
  const double neck = pathLengthUp(tree.origin, [](int32_t) { return false; }).first;
  path_lengths[0] = {neck, neck};
  bool at_origin = true;
  for (size_t i = 1; i < path_lengths.size(); ++i) {
    const auto leavesPart = [&](int32_t node) {
      return tree.nodes[size_t(node)].part != partOf(UnsidedExtremity(i));
    };
    const auto own = pathLengthUp(tree.extremities[i], leavesPart);
    // The torso may join an arm below the origin. Then both continue along the arm.
    const auto to_origin = pathLengthUp(own.second, [&](int32_t node) {
      return node == tree.origin || tree.nodes[size_t(node)].part == TreePart::kNeck;
    });
    path_lengths[i] = {own.first + to_origin.first, own.first};
    at_origin &= to_origin.second == tree.origin;
  }
  return originRank(path_lengths, at_origin ? 4 : 3, longest, options);
}

std::vector<Eigen::Vector3d> limbPath(const RerootedTree& tree, UnsidedExtremity end) {
  std::vector<Eigen::Vector3d> path;
  for (int32_t node = tree.extremities[size_t(end)];
       node >= 0 && tree.nodes[size_t(node)].part == partOf(end);
       node = tree.nodes[size_t(node)].parent)
    path.push_back(tree.nodes[size_t(node)].position);
  return path;
}

}  // namespace markerless_mocap
