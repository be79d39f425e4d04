#include "markerless_mocap/segmentation/node_grid.h"

#include <cstdlib>
#include <limits>

namespace markerless_mocap {
namespace {

constexpr int kUnitCost = 3;     // a step to a face neighbour; 4 and 5 to an edge and a corner
constexpr int kDearestStep = 5;  // buckets needed is one more
constexpr int kUnreached = std::numeric_limits<int>::max() / 2;
constexpr size_t kRow = 4;  // places compared at once

using Four = int __attribute__((vector_size(16), aligned(4)));
using Halves = int64_t __attribute__((vector_size(16), aligned(4)));

bool any(const Four& truth) {
  const auto halves = Halves(truth);
  return (halves[0] | halves[1]) != 0;
}

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
  std::vector<int> cost;
  flow(sources, &cost);
  return lengthsOf(cost);
}

std::vector<std::vector<double>> NodeGrid::geodesicsOfEach(
    const std::vector<uint32_t>& sources) const {
  std::vector<int> cost;  // a box large enough that to clear it each time would show
  std::vector<std::vector<double>> ways;
  for (const uint32_t source : sources) {
    flow({source}, &cost);
    ways.push_back(lengthsOf(cost));
  }
  return ways;
}

void NodeGrid::flow(const std::vector<uint32_t>& sources, std::vector<int>* costs) const {
  // Costs stand in the box itself, 0 outside the set: no way is ever shorter there. A row of three
  // neighbours is compared at once, with a fourth that is no neighbour and never improves.
  std::vector<int>& cost = *costs;
  cost.resize(node_at_.size() + kRow, 0);
  for (const int64_t place : place_of_) cost[place] = kUnreached;
  struct Step {
    int64_t offset;
    Four costs;
  };
  std::array<Step, 9> rows{};
  for (int row = 0; row < 9; ++row) {
    const int dj = row % 3 - 1;
    const int dk = row / 3 - 1;
    const int side = kUnitCost + std::abs(dj) + std::abs(dk);
    rows[row].offset = offset(-1, dj, dk);
    rows[row].costs = Four{side, side - 1, side, kUnreached};
  }
  std::array<std::vector<int64_t>, kDearestStep + 1> buckets;
  for (const uint32_t source : sources) {
    cost[place_of_[source]] = 0;
    buckets[0].push_back(place_of_[source]);
  }
  int idle = 0;
  for (int now = 0; idle <= kDearestStep; ++now) {
    std::vector<int64_t>& bucket = buckets[now % buckets.size()];
    idle = bucket.empty() ? idle + 1 : 0;
    for (const int64_t place : bucket) {
      if (cost[place] != now) continue;
      for (const Step& step : rows) {
        int* row = cost.data() + place + step.offset;
        const Four old = *reinterpret_cast<const Four*>(row);
        const Four better = old > step.costs + now;
        if (!any(better)) continue;
        for (int i = 0; i < 3; ++i) {
          if (better[i] == 0) continue;
          row[i] = now + step.costs[i];
          buckets[row[i] % buckets.size()].push_back(place + step.offset + i);
        }
      }
    }
    bucket.clear();
  }
}

std::vector<double> NodeGrid::lengthsOf(const std::vector<int>& cost) const {
  std::vector<double> voxels(place_of_.size());
  for (size_t node = 0; node < place_of_.size(); ++node) {
    const int reached = cost[place_of_[node]];
    voxels[node] = reached == kUnreached ? std::numeric_limits<double>::infinity()
                                         : double(reached) / kUnitCost;
  }
  return voxels;
}

}  // namespace markerless_mocap
