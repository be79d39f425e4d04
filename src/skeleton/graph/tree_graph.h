#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "markerless_mocap/products/curve_skeleton.h"

namespace markerless_mocap {

/// Adjacency lists: each edge is listed at both of its nodes.
class TreeLinks {
 public:
  struct Edge {
    int32_t a, b;
    double length;  ///< metres
  };
  struct Link {
    int32_t to;
    double length;
  };

  TreeLinks() = default;
  TreeLinks(size_t nodes, const std::vector<Edge>& edges);

  const Link* begin(int32_t node) const { return links_.data() + first_[size_t(node)]; }
  const Link* end(int32_t node) const { return links_.data() + first_[size_t(node) + 1]; }
  int count(int32_t node) const { return first_[size_t(node) + 1] - first_[size_t(node)]; }
  size_t size() const { return first_.size() - 1; }

 private:
  std::vector<int32_t> first_{0};
  std::vector<Link> links_;
};

/// The person's part of a curve skeleton as a graph. Nodes are in the order of their shortest path
/// from the top-most voxel, so parents precede children. Lengths are metres along the smoothed
/// path.
struct TreeGraph {
  double pitch = 0.0;
  std::vector<uint32_t> voxels;            ///< linear indices in the lattice
  std::vector<Eigen::Vector3d> positions;  ///< world metres; smoothed
  std::vector<int32_t> parents;  ///< parents in the tree of shortest paths; -1: the root, node 0
  std::vector<double> path_lengths;  ///< from the root along the tree, metres
  /// Edges that close a loop. The graph without them is a tree.
  std::vector<TreeLinks::Edge> loop_edges;

  size_t size() const { return voxels.size(); }
  double step(int32_t node) const {  ///< length of the edge to the parent
    return path_lengths[size_t(node)] - path_lengths[size_t(parents[size_t(node)])];
  }
};

/// How the tree of a graph is found.
struct TreePaths {
  bool breadth_first = false;  ///< by the number of voxels instead of the length
  double smoothing = 0.03;     ///< standard deviation along the skeleton, metres; 0: none
};

/// Builds the graph of the component with the most voxels, and of those within a gap of it; other
/// components are left out (Algorithm 2).
/// \param loop_length shorter loops are artefacts of the lattice and are not listed, metres
TreeGraph makeTreeGraph(const CurveSkeleton& skeleton, double gap, double loop_length,
                        const TreePaths& paths = {});

/// Path lengths along the tree from one node to all nodes, metres.
std::vector<double> treePathLengthsFrom(const TreeGraph& graph, int32_t node);

}  // namespace markerless_mocap
