#include "markerless_mocap/segmentation/eigenmap.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "markerless_mocap/segmentation/graph_modes.h"

namespace markerless_mocap {
namespace {

constexpr double kTolerance = 7e-3;  // of the residuals: spaces of modes are good to about 1e-3
constexpr int kLargestDense = 64;    // nodes up to which dense matrices are as fast

void checkConnected(const WeightedGraph& graph) {
  const std::vector<uint32_t> component = connectedComponents(graph);
  const uint32_t pieces = *std::max_element(component.begin(), component.end()) + 1;
  if (pieces == 1) return;
  throw std::invalid_argument("laplacianEigenmap: the graph falls into " + std::to_string(pieces) +
                              " pieces, it must be connected");
}

GraphModes modesOf(const WeightedGraph& graph, int modes) {
  const auto nodes = int(graph.nodeCount());
  const bool small = nodes <= kLargestDense || nodes <= 4 * modes;
  if (!small) {
    std::optional<GraphModes> found = coarseToFineModes(graph, modes, kTolerance);
    if (found) return *std::move(found);
  }
  checkConnected(graph);
  return small ? denseModes(graph, modes) : shiftInvertModes(graph, modes);
}

}  // namespace

Eigenmap laplacianEigenmap(const WeightedGraph& graph, int modes) {
  if (modes < 1) throw std::invalid_argument("laplacianEigenmap: modes must be at least 1");
  const int count = std::min(modes, std::max(0, int(graph.nodeCount()) - 1));
  if (count == 0) return {Eigen::VectorXd(0), Eigen::MatrixXd(graph.nodeCount(), 0), {}};
  GraphModes found = modesOf(graph, count);
  Eigenmap map{std::move(found.values), std::move(found.vectors), std::move(found.residuals)};
  const double scale = std::sqrt(degreesOf(graph).sum());
  for (int mode = 0; mode < count; ++mode) {
    Eigen::Index largest = 0;
    map.vectors.col(mode).cwiseAbs().maxCoeff(&largest);
    map.vectors.col(mode) *= map.vectors(largest, mode) < 0.0 ? -scale : scale;
  }
  return map;
}

}  // namespace markerless_mocap
