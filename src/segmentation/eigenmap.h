#pragma once

#include <Eigen/Core>

#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Laplacian eigenmap of a graph: solutions of L u = lambda D u with L = D - E, E the weights and
/// D the diagonal of their row sums.
struct Eigenmap {
  Eigen::VectorXd values;  ///< the smallest non-zero lambda, ascending
  /// One row per node, one column per value, with U' D U = trace(D) I: as Hsiao 2008, Eq. 3-11 but
  /// scaled so that coordinates do not depend on the number of nodes. With cells each column rises
  /// along a fixed slanted direction, which keeps its sign while the body moves a little; without
  /// cells its largest entry is positive.
  Eigen::MatrixXd vectors;
  Eigen::VectorXd residuals{};  ///< |L u - lambda D u| / (lambda |D u|) in the norm of D^-1
};

/// Residual at which spaces of modes of a body are good to an angle of about 0.001.
constexpr double kFineResidual = 7e-3;

/// \param graph connected. With cells the modes are found several times faster
/// \param modes wanted, >= 1; at most nodeCount() - 1 exist, and so many are returned
/// \param residual allowed, at least 0.001; where the fast way does not get there, a slow one goes
///   further
/// Throws std::invalid_argument when `modes` < 1 or the graph is not connected,
/// std::runtime_error when no solver converges.
Eigenmap laplacianEigenmap(const WeightedGraph& graph, int modes, double residual = kFineResidual);

}  // namespace markerless_mocap
