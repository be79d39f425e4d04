#include <Eigen/Eigenvalues>
#include <cmath>
#include <utility>
#include <vector>

#include "segmentation/eigenmap/block_kernels.h"
#include "segmentation/eigenmap/graph_hierarchy.h"
#include "segmentation/eigenmap/lobpcg.h"
#include "segmentation/eigenmap/multigrid.h"
#include "segmentation/graph_modes.h"

namespace markerless_mocap {
namespace {

constexpr size_t kEnough = 32;  // nodes of the coarsest level, which is solved with dense matrices
constexpr int kSpare = 4;       // nodes that each level has more than functions
constexpr size_t kTooMany = 200;  // maximum number of nodes for a dense solution
constexpr int kSweeps = 4;        // smoothing sweeps after the prolongation from the coarser level
constexpr float kDamping = 0.75f;
constexpr double kCoarseTolerance = 0.5;  // on all levels but the finest
constexpr int kCoarseSteps = 3;
constexpr int kFineSteps = 20;
constexpr double kConnected = 1e-11;  // minimum second eigenvalue of a connected graph

struct DensePairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;  ///< u' M u = 1
};

DensePairs densePairs(const GraphLevel& level) {
  const auto nodes = Eigen::Index(level.nodeCount());
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(nodes, nodes);
  Eigen::VectorXd scale(nodes);
  for (uint32_t node = 0; node < nodes; ++node) {
    scale[node] = 1.0 / std::sqrt(double(level.mass[node]));
    for (uint32_t e = level.row_start[node]; e < level.row_start[node + 1]; ++e) {
      laplacian(node, level.neighbor[e]) = -double(level.weight[e]);
      laplacian(node, node) += double(level.weight[e]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * laplacian *
                                                              scale.asDiagonal());
  return {solver.eigenvalues(), scale.asDiagonal() * solver.eigenvectors()};
}

Block lowestOf(const DensePairs& pairs, int width) {
  Block x(size_t(pairs.values.size()), width);
  for (size_t node = 0; node < x.nodes; ++node) {
    for (int k = 0; k < width; ++k) {
      x.row(node)[k] = float(pairs.vectors(Eigen::Index(node), k + 1));
    }
  }
  return x;
}

GraphModes modesOf(const DensePairs& pairs, int modes) {
  return {pairs.values.segment(1, modes), pairs.vectors.middleCols(1, modes),
          Eigen::VectorXd::Zero(modes)};
}

Block carriedDown(const GraphLevel& level, const Block& coarse) {
  const Block zero(level.nodeCount(), coarse.width);
  Block x = zero;
  Block next = zero;
  prolongate(level, 1.0f, coarse, &x);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    relax(level, kDamping, zero, x, &next);
    std::swap(x, next);
  }
  return x;
}

GraphModes lowestOf(const Lobpcg& solver, int modes) {
  const Block& x = solver.vectors();
  GraphModes result{solver.values().head(modes), Eigen::MatrixXd(Eigen::Index(x.nodes), modes),
                    solver.residuals().head(modes)};
  for (size_t node = 0; node < x.nodes; ++node) {
    for (int k = 0; k < modes; ++k) {
      result.vectors(Eigen::Index(node), k) = double(x.row(node)[k]);
    }
  }
  return result;
}

/// Number of columns for `modes` modes: at least one more, so that the last mode converges.
int widthFor(int modes) {
  return (modes / 4 + 1) * 4;
}

}  // namespace

std::optional<GraphModes> coarseToFineModes(const WeightedGraph& graph, int modes,
                                            double tolerance) {
  if (graph.cell.empty() || widthFor(modes) > kWidest) return {};
  const std::vector<GraphLevel> levels =
      hierarchyForModes(gatherNodes(graph, allNodesOf(graph)), modes);
  if (levels.size() == 1) return {};
  return coarseToFineModes(levels, modes, tolerance);
}

std::vector<GraphLevel> hierarchyForModes(BlockGraph graph, int modes) {
  return buildHierarchy(std::move(graph), size_t(widthFor(modes) + kSpare), kEnough);
}

std::optional<GraphModes> coarseToFineModes(const std::vector<GraphLevel>& levels, int modes,
                                            double tolerance) {
  const int width = widthFor(modes);
  const size_t coarsest = levels.size() - 1;
  if (levels[coarsest].nodeCount() > kTooMany) return {};
  const DensePairs pairs = densePairs(levels[coarsest]);
  if (pairs.values[1] < kConnected) return {};
  if (coarsest == 0) return modesOf(pairs, modes);
  Multigrid multigrid(levels, pairs.values, pairs.vectors, width);
  Block x = lowestOf(pairs, width);
  for (size_t number = coarsest - 1; number > 0; --number) {
    Lobpcg solver(levels[number], number, &multigrid, carriedDown(levels[number], x));
    solver.run(modes, kCoarseTolerance, kCoarseSteps);
    x = solver.vectors();
  }
  Lobpcg solver(levels[0], 0, &multigrid, carriedDown(levels[0], x));
  if (!solver.run(modes, tolerance, kFineSteps)) return {};
  return lowestOf(solver, modes);
}

}  // namespace markerless_mocap
