#include "skeleton/tree_chains.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

struct Link {
  int32_t to;
  double length;
  bool used;
};

std::vector<std::vector<Link>> linksOf(const TreeGraph& graph, bool loops) {
  std::vector<std::vector<Link>> links(graph.size());
  const auto join = [&](int32_t a, int32_t b) {
    const double length = (graph.positions[size_t(a)] - graph.positions[size_t(b)]).norm();
    links[size_t(a)].push_back({b, length, false});
    links[size_t(b)].push_back({a, length, false});
  };
  for (size_t node = 1; node < graph.size(); ++node) join(int32_t(node), graph.parents[node]);
  if (loops)
    for (const auto& [a, b] : graph.loop_edges) join(a, b);
  return links;
}

void markUsed(std::vector<Link>& links, int32_t to) {
  for (Link& link : links)
    if (link.to == to) link.used = true;
}

/// Follows a link until the next vertex.
TreeChain follow(std::vector<std::vector<Link>>& links, const std::vector<int32_t>& vertex_of,
                 int32_t from, Link& first) {
  TreeChain chain{vertex_of[size_t(from)], -1, 0.0, {from}};
  int32_t before = from;
  Link* link = &first;
  while (true) {
    link->used = true;
    markUsed(links[size_t(link->to)], before);
    chain.length += link->length;
    chain.nodes.push_back(link->to);
    const int32_t at = link->to;
    if (vertex_of[size_t(at)] >= 0) break;
    std::vector<Link>& next = links[size_t(at)];
    link = next[0].to == before ? &next[1] : &next[0];
    before = at;
  }
  chain.b = vertex_of[size_t(chain.nodes.back())];
  return chain;
}

/// Makes one chain of two that meet in a vertex.
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

/// If just two ends of chains are left at a vertex, it is no branching any more.
void smoothVertex(int32_t vertex, TreeChains* chains) {
  if (vertex == 0) return;
  std::vector<size_t> at;
  for (size_t i = 0; i < chains->chains.size(); ++i) {
    const TreeChain& chain = chains->chains[i];
    if (chain.a == vertex && chain.b == vertex) return;
    if (chain.a == vertex || chain.b == vertex) at.push_back(i);
  }
  if (at.size() != 2) return;
  TreeChain one =
      joined(std::move(chains->chains[at[0]]), std::move(chains->chains[at[1]]), vertex);
  chains->chains[at[0]] = std::move(one);
  chains->chains.erase(chains->chains.begin() + long(at[1]));
}

}  // namespace

int TreeChains::degree(int32_t vertex) const {
  int count = 0;
  for (const TreeChain& chain : chains) count += (chain.a == vertex) + (chain.b == vertex);
  return count;
}

TreeChains makeChains(const TreeGraph& graph, bool loops) {
  TreeChains out;
  if (graph.size() == 0) return out;
  std::vector<std::vector<Link>> links = linksOf(graph, loops);
  std::vector<int32_t> vertex_of(graph.size(), -1);
  for (size_t node = 0; node < graph.size(); ++node) {
    if (node != 0 && links[node].size() == 2) continue;
    vertex_of[node] = int32_t(out.vertices.size());
    out.vertices.push_back(int32_t(node));
  }
  for (const int32_t node : out.vertices) {
    for (Link& link : links[size_t(node)])
      if (!link.used) out.chains.push_back(follow(links, vertex_of, node, link));
  }
  return out;
}

void removeChain(size_t chain, TreeChains* chains) {
  const int32_t a = chains->chains[chain].a, b = chains->chains[chain].b;
  chains->chains.erase(chains->chains.begin() + long(chain));
  smoothVertex(a, chains);
  if (b != a) smoothVertex(b, chains);
}

void pruneChains(double least, bool keep_root, TreeChains* chains) {
  while (true) {
    size_t shortest = chains->chains.size();
    double length = least;
    for (size_t i = 0; i < chains->chains.size(); ++i) {
      const TreeChain& chain = chains->chains[i];
      if (chain.length >= length || chain.a == chain.b) continue;
      const auto isEnd = [&](int32_t v) {
        return chains->degree(v) == 1 && !(keep_root && v == 0);
      };
      if (!isEnd(chain.a) && !isEnd(chain.b)) continue;
      length = chain.length;
      shortest = i;
    }
    if (shortest == chains->chains.size()) return;
    removeChain(shortest, chains);
  }
}

}  // namespace markerless_mocap
