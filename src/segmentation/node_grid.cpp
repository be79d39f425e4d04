#include "markerless_mocap/segmentation/node_grid.h"

#include <cstdlib>
#include <limits>

namespace markerless_mocap {
namespace {

constexpr int kUnitCost = 3;     // a step to a face neighbour; 4 and 5 to an edge and a corner
constexpr int kDearestStep = 5;  // buckets needed is one more

}  // namespace

NodeGrid::NodeGrid(const std::vector<Eigen::Vector3i>& cells) {
  if (cells.empty()) return;
  Eigen::Vector3i low = cells.front();
  Eigen::Vector3i high = cells.front();
  for (const Eigen::Vector3i& cell : cells) {
    low = low.cwiseMin(cell);
    high = high.cwiseMax(cell);
  }
  for (int axis = 0; axis < 3; ++axis) size_[axis] = high[axis] - low[axis] + 3;
  node_at_.assign(size_t(size_[0]) * size_[1] * size_[2], -1);
  place_of_.reserve(cells.size());
  for (size_t node = 0; node < cells.size(); ++node) {
    const Eigen::Vector3i at = cells[node] - low;
    place_of_.push_back(offset(at.x() + 1, at.y() + 1, at.z() + 1));
    node_at_[place_of_.back()] = int32_t(node);
  }
}

std::vector<double> NodeGrid::geodesics(const std::vector<uint32_t>& sources) const {
  struct Step {
    int64_t offset;
    int cost;
  };
  std::vector<Step> steps;
  for (int dk = -1; dk <= 1; ++dk) {
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        const int axes = std::abs(di) + std::abs(dj) + std::abs(dk);
        if (axes > 0) steps.push_back({offset(di, dj, dk), kUnitCost + axes - 1});
      }
    }
  }
  constexpr int kUnreached = std::numeric_limits<int>::max();
  std::vector<int> cost(place_of_.size(), kUnreached);
  std::array<std::vector<uint32_t>, kDearestStep + 1> buckets;
  for (const uint32_t source : sources) cost[source] = 0;
  buckets[0] = sources;
  int idle = 0;
  for (int now = 0; idle <= kDearestStep; ++now) {
    std::vector<uint32_t>& bucket = buckets[now % buckets.size()];
    idle = bucket.empty() ? idle + 1 : 0;
    for (const uint32_t node : bucket) {
      if (cost[node] != now) continue;
      for (const Step& step : steps) {
        const int32_t next = node_at_[place_of_[node] + step.offset];
        if (next < 0 || cost[next] <= now + step.cost) continue;
        cost[next] = now + step.cost;
        buckets[(now + step.cost) % buckets.size()].push_back(uint32_t(next));
      }
    }
    bucket.clear();
  }
  std::vector<double> voxels(cost.size());
  for (size_t node = 0; node < cost.size(); ++node) {
    voxels[node] = cost[node] == kUnreached ? std::numeric_limits<double>::infinity()
                                            : double(cost[node]) / kUnitCost;
  }
  return voxels;
}

}  // namespace markerless_mocap
