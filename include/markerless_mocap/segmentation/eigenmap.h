#pragma once

#include <Eigen/Core>

#include "markerless_mocap/segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Laplacian eigenmap of a graph: solutions of L u = lambda D u with L = D - E, E the weights and
/// D the diagonal of their row sums.
struct Eigenmap {
  Eigen::VectorXd values;  ///< the smallest non-zero lambda, ascending
  /// One row per node, one column per value, with U' D U = trace(D) I: as Hsiao 2008, Eq. 3-11 but
  /// scaled so that coordinates do not depend on the number of nodes. The largest entry of each
  /// column is positive.
  Eigen::MatrixXd vectors;
  Eigen::VectorXd residuals{};  ///< |L u - lambda D u| / (lambda |D u|) in the norm of D^-1
};

/// \param graph connected
/// \param modes wanted, >= 1; at most nodeCount() - 1 exist, and so many are returned
/// Throws std::invalid_argument when `modes` < 1, std::runtime_error when the solver does not
/// converge.
Eigenmap laplacianEigenmap(const WeightedGraph& graph, int modes);

}  // namespace markerless_mocap
