#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "segmentation/eigenmap/graph_hierarchy.h"
#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Solutions of L u = lambda D u on a connected graph, without the constant one; see Eigenmap.
struct GraphModes {
  Eigen::VectorXd values;     ///< the lowest, ascending
  Eigen::MatrixXd vectors;    ///< a column per value, u' D u = 1
  Eigen::VectorXd residuals;  ///< |L u - lambda D u| / (lambda |D u|) in the norm of D^-1
};

/// Sum of the weights at each node: the diagonal of D.
Eigen::VectorXd degreesOf(const WeightedGraph& graph);

/// By dense matrices: for small graphs.
/// \param modes from 1 to nodeCount() - 1
GraphModes denseModes(const WeightedGraph& graph, int modes);

/// By Lanczos' method on the shifted and inverted Laplacian, with a sparse Cholesky decomposition
/// of it: for any graph, to 1e-6 of the values, and the reference of what is faster.
/// Throws std::runtime_error when it does not converge.
GraphModes shiftInvertModes(const WeightedGraph& graph, int modes);

/// Coarse to fine, for graphs with cells: the modes of a graph of few nodes are carried down a
/// hierarchy and improved on each level, see Lobpcg.
/// \param tolerance residual to reach, >= 1e-3 (the work is in single precision)
/// \return nothing where the method does not fit (no cells, few nodes, many modes) or does not
///   converge
std::optional<GraphModes> coarseToFineModes(const WeightedGraph& graph, int modes,
                                            double tolerance);

/// The hierarchy that so many modes of a graph are found on.
std::vector<GraphLevel> hierarchyForModes(BlockGraph graph, int modes);

/// Modes of the finest of some levels, M of its masses in the place of D: where they are the upper
/// levels of a hierarchy, modes of the whole graph that are constant on each of its nodes.
/// \param modes less than that level's nodes
/// \return nothing where the coarsest level is large or the method does not converge
std::optional<GraphModes> coarseToFineModes(const std::vector<GraphLevel>& levels, int modes,
                                            double tolerance);

}  // namespace markerless_mocap
