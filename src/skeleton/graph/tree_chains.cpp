#include "skeleton/graph/tree_chains.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

/// Joins two chains that meet at a vertex.
TreeChain joined(TreeChain first, TreeChain second, int32_t vertex) {
  if (first.a == vertex) {
    std::swap(first.a, first.b);
    std::reverse(first.nodes.begin(), first.nodes.end());
  }
  if (second.b == vertex) {
    std::swap(second.a, second.b);
    std::reverse(second.nodes.begin(), second.nodes.end());
  }
  first.nodes.insert(first.nodes.end(), second.nodes.begin() + 1, second.nodes.end());
  first.b = second.b;
  first.length += second.length;
  return first;
}

/// Joins the chains at a vertex that has only two of them left, as it is no branching node any
/// more. The root stays a vertex.
void smoothVertex(int32_t vertex, TreeChains* tree) {
  if (vertex == 0 || tree->degrees[size_t(vertex)] != 2) return;
  std::vector<size_t> at;
  for (size_t i = 0; i < tree->chains.size(); ++i)
    if (tree->chains[i].a == vertex || tree->chains[i].b == vertex) at.push_back(i);
  TreeChain one = joined(std::move(tree->chains[at[0]]), std::move(tree->chains[at[1]]), vertex);
  tree->chains[at[0]] = std::move(one);
  tree->chains.erase(tree->chains.begin() + long(at[1]));
  tree->degrees[size_t(vertex)] = 0;
}

}  // namespace

TreeChains makeChains(const TreeGraph& graph) {
  TreeChains out;
  std::vector<int> children(graph.size(), 0);
  for (size_t node = 1; node < graph.size(); ++node) ++children[size_t(graph.parents[node])];
  std::vector<int32_t> vertex_of(graph.size(), -1);
  for (size_t node = 0; node < graph.size(); ++node) {
    if (node != 0 && children[node] == 1) continue;
    vertex_of[node] = int32_t(out.vertices.size());
    out.vertices.push_back(int32_t(node));
    out.degrees.push_back(children[node] + (node != 0));
  }
  for (size_t v = 1; v < out.vertices.size(); ++v) {
    TreeChain chain{int32_t(v), -1, 0.0, {out.vertices[v]}};
    do {
      const int32_t at = chain.nodes.back();
      chain.length += graph.step(at);
      chain.nodes.push_back(graph.parents[size_t(at)]);
    } while (vertex_of[size_t(chain.nodes.back())] < 0);
    chain.b = vertex_of[size_t(chain.nodes.back())];
    out.chains.push_back(std::move(chain));
  }
  return out;
}

void removeChain(size_t chain, TreeChains* tree) {
  const int32_t ends[] = {tree->chains[chain].a, tree->chains[chain].b};
  tree->chains.erase(tree->chains.begin() + long(chain));
  for (const int32_t v : ends) --tree->degrees[size_t(v)];
  for (const int32_t v : ends) smoothVertex(v, tree);
}

void pruneChains(double min_length, TreeChains* tree) {
  const auto isEnd = [&](int32_t v) { return v != 0 && tree->degrees[size_t(v)] == 1; };
  while (true) {
    size_t shortest = tree->chains.size();
    double length = min_length;
    for (size_t i = 0; i < tree->chains.size(); ++i) {
      const TreeChain& chain = tree->chains[i];
      if (chain.length >= length || !(isEnd(chain.a) || isEnd(chain.b))) continue;
      length = chain.length;
      shortest = i;
    }
    if (shortest == tree->chains.size()) return;
    removeChain(shortest, tree);
  }
}

}  // namespace markerless_mocap
