#include "segmentation/eigenmap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "segmentation/graph_modes.h"

namespace markerless_mocap {
namespace {

constexpr int kMaxDense = 64;  // up to this number of nodes dense matrices are as fast
constexpr double kSlant[] = {0.6, 0.35, 1.0};

void checkConnected(const WeightedGraph& graph) {
  const std::vector<uint32_t> component = connectedComponents(graph);
  const uint32_t count = *std::max_element(component.begin(), component.end()) + 1;
  if (count == 1) return;
  throw std::invalid_argument("laplacianEigenmap: the graph has " + std::to_string(count) +
                              " components, it must be connected");
}

GraphModes modesOf(const WeightedGraph& graph, int modes, double residual) {
  const auto nodes = int(graph.nodeCount());
  const bool small = nodes <= kMaxDense || nodes <= 4 * modes;
  if (!small) {
    std::optional<GraphModes> found = coarseToFineModes(graph, modes, residual);
    if (found) return *std::move(found);
  }
  checkConnected(graph);
  return small ? denseModes(graph, modes) : shiftInvertModes(graph, modes);
}

/// A function that increases along one slanted direction, chosen so that hardly any mode of a body
/// is symmetric about it; 0 without cells.
Eigen::VectorXd heights(const WeightedGraph& graph) {
  Eigen::VectorXd height = Eigen::VectorXd::Zero(Eigen::Index(graph.nodeCount()));
  for (size_t node = 0; node < graph.cell.size(); ++node) {
    const LatticeCell& cell = graph.cell[node];
    height[Eigen::Index(node)] = kSlant[0] * cell.i() + kSlant[1] * cell.j() + kSlant[2] * cell.k();
  }
  return height;
}

bool isTurned(const Eigen::VectorXd& mode, const Eigen::VectorXd& upward) {
  const double rise = mode.dot(upward);
  if (rise != 0.0) return rise < 0.0;
  Eigen::Index largest = 0;
  mode.cwiseAbs().maxCoeff(&largest);
  return mode[largest] < 0.0;
}

}  // namespace

Eigenmap laplacianEigenmap(const WeightedGraph& graph, int modes, double residual) {
  if (modes < 1) throw std::invalid_argument("laplacianEigenmap: modes must be at least 1");
  const int count = std::min(modes, std::max(0, int(graph.nodeCount()) - 1));
  if (count == 0) return {Eigen::VectorXd(0), Eigen::MatrixXd(graph.nodeCount(), 0), {}};
  GraphModes found = modesOf(graph, count, residual);
  Eigenmap map{std::move(found.values), std::move(found.vectors), std::move(found.residuals)};
  const Eigen::VectorXd degree = degreesOf(graph);
  const Eigen::VectorXd upward = degree.cwiseProduct(heights(graph));
  const double scale = std::sqrt(degree.sum());
  for (int mode = 0; mode < count; ++mode) {
    map.vectors.col(mode) *= isTurned(map.vectors.col(mode), upward) ? -scale : scale;
  }
  return map;
}

}  // namespace markerless_mocap
