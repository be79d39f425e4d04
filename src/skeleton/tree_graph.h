#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "markerless_mocap/skeleton/curve_skeleton.h"

namespace markerless_mocap {

struct TreeEdge {
  int32_t to;
  double length;  ///< metres
};

/// The person's part of a curve skeleton as a graph, its nodes in the order in which a walk along
/// shortest paths from the top-most voxel reaches them. Lengths are metres along the path.
struct TreeGraph {
  double pitch = 0.0;
  std::vector<uint32_t> voxels;            ///< linear indices in the lattice
  std::vector<Eigen::Vector3d> positions;  ///< world metres
  std::vector<int32_t> parents;            ///< of the tree of shortest paths; -1: the root, node 0
  std::vector<double> ways;                ///< from the root
  /// Edges that close a loop longer than a bend of the voxels; without them the rest is a tree.
  std::vector<std::pair<int32_t, int32_t>> loop_edges;

  size_t size() const { return voxels.size(); }
};

/// Takes the component with the most voxels and joins those to it that lie within a gap of it; the
/// others are left out (Algorithm 2, but shortest paths instead of breadth first).
/// \param loop_length loops shorter than this are bends of the voxels, metres
TreeGraph makeTreeGraph(const CurveSkeleton& skeleton, double gap, double loop_length);

}  // namespace markerless_mocap
