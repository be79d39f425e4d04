#pragma once

#include <cstddef>
#include <vector>

namespace markerless_mocap {

/// A link between two nodes.
struct Link {
  size_t a = 0, b = 0;
  double weight = 0.0;  ///< the more, the better it is known
};

/// A step of a walk over a tree; `link` leads from `parent` to `child`.
struct TreeStep {
  size_t parent = 0, child = 0, link = 0;
};

/// The links of greatest weight that join all nodes that can be joined (Prim), from a root outward.
std::vector<TreeStep> spanningTree(size_t nodes, const std::vector<Link>& links, size_t root);

/// Number of the group of joined nodes that each node belongs to.
std::vector<size_t> groupsOf(size_t nodes, const std::vector<Link>& links);

/// The node with the greatest sum of link weights among those in a group.
size_t strongestNode(const std::vector<Link>& links, const std::vector<size_t>& groups,
                     size_t group);

}  // namespace markerless_mocap
