#include "segmentation/eigenmap/node_grid.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr int16_t kFace = 3;  // cost of a step to a face neighbour, one voxel
constexpr int16_t kEdge = 4;
constexpr int16_t kCorner = 5;
/// Longer paths are treated as unreached; no sum with a step overflows.
constexpr int16_t kUnreached = 30000;

/// Path costs from eight sources, computed together.
constexpr size_t kLanes = 8;
using Lanes = int16_t __attribute__((vector_size(2 * kLanes)));

Lanes lesser(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}
int16_t lesser(int16_t a, int16_t b) {
  return std::min(a, b);
}

bool differ(const Lanes& a, const Lanes& b) {
  using Halves = int64_t __attribute__((vector_size(2 * kLanes)));
  const auto halves = Halves(a != b);
  return (halves[0] | halves[1]) != 0;
}
bool differ(int16_t a, int16_t b) {
  return a != b;
}

/// The 13 of a cell's 26 neighbours that come earlier in a sweep along the lattice.
struct Earlier {
  std::array<int64_t, 3> faces;
  std::array<int64_t, 6> edges;
  std::array<int64_t, 4> corners;
};

double lengthOf(int16_t cost) {
  return cost >= kUnreached ? std::numeric_limits<double>::infinity() : double(cost) / kFace;
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
    const int64_t place = offset(at.x() + 1, at.y() + 1, at.z() + 1);
    if (!place_of_.empty() && place <= place_of_.back())
      throw std::invalid_argument("cells of a grid must ascend by z, then y, then x");
    place_of_.push_back(place);
    node_at_[place_of_.back()] = int32_t(node);
  }
}

template <class Costs>
void NodeGrid::sweep(const std::vector<uint32_t>& sources, std::vector<Costs>* costs) const {
  const int64_t y = offset(0, 1, 0), z = offset(0, 0, 1);
  const Earlier earlier{{-1, -y, -z},
                        {-1 - y, 1 - y, -1 - z, 1 - z, -y - z, y - z},
                        {-1 - y - z, 1 - y - z, -1 + y - z, 1 + y - z}};
  Costs* const cost = costs->data() + 1;
  const auto relax = [&](int64_t node, int64_t sense) {
    const int32_t* const here = node_at_.data() + place_of_[node];
    const auto least = [&](const auto& steps) {
      Costs found = cost[here[sense * steps[0]]];
      for (size_t i = 1; i < steps.size(); ++i) found = lesser(found, cost[here[sense * steps[i]]]);
      return found;
    };
    const Costs geodesic =
        lesser(least(earlier.faces) + kFace,
               lesser(least(earlier.edges) + kEdge, least(earlier.corners) + kCorner));
    const Costs before = cost[node];
    cost[node] = lesser(before, geodesic);
    return differ(cost[node], before);
  };
  const auto pass = [&](int64_t begin, int64_t sense) {
    int64_t last_fallen = -1;
    for (int64_t node = begin; node >= 0 && node < int64_t(place_of_.size()); node += sense)
      if (relax(node, sense)) last_fallen = node;
    return last_fallen;
  };
  const auto [first, last] = std::minmax_element(sources.begin(), sources.end());
  int64_t turn = std::max(pass(*first, 1), int64_t(*last));
  for (int64_t sense = -1; turn >= 0; sense = -sense) turn = pass(turn, sense);
}

std::vector<double> NodeGrid::geodesics(const std::vector<uint32_t>& sources) const {
  std::vector<int16_t> cost(place_of_.size() + 1, kUnreached);
  for (const uint32_t source : sources) cost[source + 1] = 0;
  if (!sources.empty()) sweep(sources, &cost);
  std::vector<double> voxels;
  voxels.reserve(place_of_.size());
  for (size_t node = 0; node < place_of_.size(); ++node) voxels.push_back(lengthOf(cost[node + 1]));
  return voxels;
}

std::vector<std::vector<double>> NodeGrid::geodesicsOfEach(
    const std::vector<uint32_t>& sources) const {
  std::vector<std::vector<double>> path_lengths;
  std::vector<Lanes> cost;
  for (size_t done = 0; done < sources.size(); done += kLanes) {
    const size_t end = std::min(done + kLanes, sources.size());
    cost.assign(place_of_.size() + 1, Lanes{} + kUnreached);
    for (size_t i = done; i < end; ++i) cost[sources[i] + 1][i - done] = 0;
    sweep({sources.begin() + long(done), sources.begin() + long(end)}, &cost);
    for (size_t lane = 0; lane < end - done; ++lane) {
      std::vector<double>& voxels = path_lengths.emplace_back();
      voxels.reserve(place_of_.size());
      for (size_t node = 0; node < place_of_.size(); ++node)
        voxels.push_back(lengthOf(cost[node + 1][lane]));
    }
  }
  return path_lengths;
}

std::vector<uint32_t> NodeGrid::Region::takeConnected(uint32_t start, uint32_t wanted) {
  std::vector<uint32_t> found;
  const auto take = [&](int64_t place) {
    inside_[place] = 0;
    found.push_back(uint32_t(grid_.node_at_[place]));
  };
  take(grid_.place_of_[start]);
  for (size_t next = 0; next < found.size() && found[next] != wanted; ++next) {
    const int64_t place = grid_.place_of_[found[next]];
    for (int row = 0; row < 9; ++row) {
      const int64_t first = place + grid_.offset(-1, row % 3 - 1, row / 3 - 1);
      for (int64_t at = first; at < first + 3; ++at)
        if (inside_[at] != 0) take(at);
    }
  }
  return found;
}

}  // namespace markerless_mocap
