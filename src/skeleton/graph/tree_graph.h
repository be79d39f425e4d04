#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "markerless_mocap/products/curve_skeleton.h"

namespace markerless_mocap {

/// Edges between numbered nodes, each known at both its ends.
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

/// The person's part of a curve skeleton as a graph, its nodes in the order in which a walk along
/// shortest paths from the top-most voxel reaches them, so parents come before children. Lengths
/// are metres along the smoothed path.
struct TreeGraph {
  double pitch = 0.0;
  std::vector<uint32_t> voxels;            ///< linear indices in the lattice
  std::vector<Eigen::Vector3d> positions;  ///< world metres; steps between voxels are levelled out
  std::vector<int32_t> parents;            ///< of the tree of shortest paths; -1: the root, node 0
  std::vector<double> path_lengths;        ///< from the root along the tree
  /// Edges that close a loop longer than a bend of the voxels; without them the rest is a tree.
  std::vector<TreeLinks::Edge> loop_edges;

  size_t size() const { return voxels.size(); }
  double step(int32_t node) const {  ///< to the parent
    return path_lengths[size_t(node)] - path_lengths[size_t(parents[size_t(node)])];
  }
};

/// Takes the component with the most voxels and joins those to it that lie within a gap of it; the
/// others are left out (Algorithm 2, but shortest paths instead of breadth first).
/// \param loop_length loops shorter than this are bends of the voxels, metres
TreeGraph makeTreeGraph(const CurveSkeleton& skeleton, double gap, double loop_length);

/// Ways along the tree from one node to all.
std::vector<double> treePathLengthsFrom(const TreeGraph& graph, int32_t node);

}  // namespace markerless_mocap
