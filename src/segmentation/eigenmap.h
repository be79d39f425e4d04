#pragma once

#include <Eigen/Core>

#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Laplacian eigenmap of a graph: solutions of L u = lambda D u with L = D - E. E is the matrix of
/// weights, D the diagonal matrix of its row sums.
struct Eigenmap {
  Eigen::VectorXd values;  ///< the smallest non-zero lambda, ascending
  /// One row per node, one column per value, with U' D U = trace(D) I. This is Hsiao 2008, Eq.
  /// 3-11, scaled so that coordinates do not depend on the number of nodes. Signs: if the graph has
  /// cells, each column increases along a fixed slanted direction, which keeps its sign under small
  /// motions of the body; else its entry of the largest magnitude is positive.
  Eigen::MatrixXd vectors;
  Eigen::VectorXd residuals{};  ///< |L u - lambda D u| / (lambda |D u|) in the norm of D^-1
};

/// Residual at which the eigenspaces of a body are accurate to an angle of about 0.001.
constexpr double kFineResidual = 7e-3;

/// \param graph a connected graph. If it has cells, the modes are found several times faster
/// \param modes number of modes, >= 1; limited to nodeCount() - 1, the number that exist
/// \param residual allowed residual, at least 0.001; if the fast solver does not reach it, a slow
///   one is used
/// Throws std::invalid_argument if `modes` < 1 or the graph is not connected, std::runtime_error if
/// no solver converges.
Eigenmap laplacianEigenmap(const WeightedGraph& graph, int modes, double residual = kFineResidual);

}  // namespace markerless_mocap
