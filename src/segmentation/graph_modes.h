#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "segmentation/eigenmap/graph_hierarchy.h"
#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Solutions of L u = lambda D u on a connected graph, without the constant one; see Eigenmap.
struct GraphModes {
  Eigen::VectorXd values;     ///< the smallest lambda, ascending
  Eigen::MatrixXd vectors;    ///< one column per value, u' D u = 1
  Eigen::VectorXd residuals;  ///< |L u - lambda D u| / (lambda |D u|) in the norm of D^-1
};

/// Sum of the weights at each node: the diagonal of D.
Eigen::VectorXd degreesOf(const WeightedGraph& graph);

/// Solution with dense matrices, for small graphs.
/// \param modes from 1 to nodeCount() - 1
GraphModes denseModes(const WeightedGraph& graph, int modes);

/// Lanczos method on the shifted and inverted Laplacian, with a sparse Cholesky decomposition.
/// Works for any graph, to a relative precision of 1e-6; the reference for the faster methods.
/// Throws std::runtime_error if it does not converge.
GraphModes shiftInvertModes(const WeightedGraph& graph, int modes);

/// Coarse-to-fine solution for graphs with cells: the modes of a graph of few nodes are prolongated
/// through a hierarchy and improved on each level, see Lobpcg.
/// \param tolerance residual to reach, >= 1e-3 (the work is in single precision)
/// \return empty if the method is not applicable (no cells, few nodes, many modes) or does not
///   converge
std::optional<GraphModes> coarseToFineModes(const WeightedGraph& graph, int modes,
                                            double tolerance);

/// The hierarchy on which `modes` modes of a graph are computed.
std::vector<GraphLevel> hierarchyForModes(BlockGraph graph, int modes);

/// Modes of the first level, with the masses M in place of D. If the levels are the coarser part of
/// a hierarchy, these are modes of the whole graph that are constant on each of that level's nodes.
/// \param modes less than the number of nodes of that level
/// \return empty if the coarsest level is too large or the method does not converge
std::optional<GraphModes> coarseToFineModes(const std::vector<GraphLevel>& levels, int modes,
                                            double tolerance);

}  // namespace markerless_mocap
