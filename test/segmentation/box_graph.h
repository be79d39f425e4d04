#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Nodes of a box, joined to their face neighbours, that stand at `place` (a function of i, j, k).
template <class Place>
WeightedGraph boxGraph(int nx, int ny, int nz, const Place& place) {
  std::vector<Edge> edges;
  const auto node = [&](int i, int j, int k) { return uint32_t(i + nx * (j + ny * k)); };
  std::vector<LatticeCell> cells;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        cells.push_back(place(i, j, k));
        if (i + 1 < nx) edges.push_back({node(i, j, k), node(i + 1, j, k), 1.0});
        if (j + 1 < ny) edges.push_back({node(i, j, k), node(i, j + 1, k), 1.0});
        if (k + 1 < nz) edges.push_back({node(i, j, k), node(i, j, k + 1), 1.0});
      }
    }
  }
  WeightedGraph graph = graphOfEdges(cells.size(), edges);
  graph.cell = cells;
  return graph;
}

inline WeightedGraph box(int nx, int ny, int nz) {
  return boxGraph(nx, ny, nz, [](int i, int j, int k) { return LatticeCell(i, j, k); });
}

/// Sine of the largest angle between two spaces given by bases that are orthonormal under D.
inline double sineBetween(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                          const Eigen::VectorXd& degree) {
  const Eigen::MatrixXd rest = a - b * (b.transpose() * degree.asDiagonal() * a);
  const Eigen::MatrixXd squares = rest.transpose() * degree.asDiagonal() * rest;
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(squares).eigenvalues().maxCoeff());
}

}  // namespace markerless_mocap
