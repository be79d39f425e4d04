#include "segmentation/limbs/merge_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/disjoint_sets.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

/// Components of the nodes added so far, each with its highest maximum.
class Components {
 public:
  explicit Components(size_t nodes) : parent_(nodes, kNone), peak_(nodes, kNone) {}

  void add(uint32_t node, uint32_t peak) {
    parent_[node] = node;
    peak_[node] = peak;
  }
  bool has(uint32_t node) const { return parent_[node] != kNone; }
  uint32_t root(uint32_t node) { return rootOf(&parent_, node); }
  uint32_t peak(uint32_t root) const { return peak_[root]; }
  void join(uint32_t root, uint32_t other, uint32_t peak) {
    parent_[other] = root;
    peak_[root] = peak;
  }

 private:
  std::vector<uint32_t> parent_;
  std::vector<uint32_t> peak_;
};

/// Nodes in descending order of height, nodes of equal height by index.
std::vector<uint32_t> descendingNodes(const std::vector<double>& height) {
  struct Place {
    double height;
    uint32_t node;
  };
  std::vector<Place> places;
  places.reserve(height.size());
  for (uint32_t node = 0; node < height.size(); ++node) places.push_back({height[node], node});
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.height != b.height ? a.height > b.height : a.node < b.node;
  });
  std::vector<uint32_t> descending;
  descending.reserve(places.size());
  for (const Place& place : places) descending.push_back(place.node);
  return descending;
}

}  // namespace

std::vector<double> distanceFromCore(const Eigenmap& map, const std::vector<uint32_t>& core) {
  if (map.values.size() == 0) return std::vector<double>(size_t(map.vectors.rows()), 0.0);
  const Eigen::VectorXd scale = (map.values[0] / map.values.array()).sqrt();
  Eigen::RowVectorXd origin = Eigen::RowVectorXd::Zero(map.values.size());
  for (const uint32_t node : core) origin += map.vectors.row(node);
  origin /= double(core.size());
  Eigen::ArrayXd square = Eigen::ArrayXd::Zero(map.vectors.rows());
  for (Eigen::Index mode = 0; mode < scale.size(); ++mode) {
    square += ((map.vectors.col(mode).array() - origin[mode]) * scale[mode]).square();
  }
  const Eigen::ArrayXd distance = square.sqrt();
  return {distance.data(), distance.data() + distance.size()};
}

std::vector<uint32_t> persistentMaxima(const Adjacency& graph, const std::vector<double>& height,
                                       int count) {
  const std::vector<uint32_t> descending = descendingNodes(height);
  std::vector<std::pair<double, uint32_t>> ended;  // persistence, peak
  const auto higher = [&](uint32_t a, uint32_t b) {
    return height[a] != height[b] ? height[a] > height[b] : a < b;
  };
  Components components(height.size());
  for (const uint32_t node : descending) {
    components.add(node, node);
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      if (!components.has(graph.neighbor[e])) continue;
      const uint32_t here = components.root(node), there = components.root(graph.neighbor[e]);
      if (here == there) continue;
      uint32_t kept = components.peak(there), lower = components.peak(here);
      if (higher(lower, kept)) std::swap(kept, lower);
      if (height[lower] > height[node]) ended.emplace_back(height[lower] - height[node], lower);
      components.join(there, here, kept);
    }
  }
  if (!descending.empty()) ended.emplace_back(height[descending.front()], descending.front());
  std::sort(ended.begin(), ended.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::vector<uint32_t> peaks;
  for (size_t i = 0; i < ended.size() && i < size_t(count); ++i) peaks.push_back(ended[i].second);
  return peaks;
}

}  // namespace markerless_mocap
