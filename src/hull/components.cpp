#include "hull/components.h"

#include <algorithm>
#include <numeric>

#include "hull/neighbors.h"

namespace markerless_mocap {
namespace {

/// Disjoint sets whose representative is the first member.
class DisjointSets {
 public:
  explicit DisjointSets(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  size_t find(size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(size_t a, size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = uint32_t(std::min(a, b));
  }

 private:
  std::vector<uint32_t> parent_;
};

/// The 13 of 26 neighbours that come later in linear order.
std::vector<Eigen::Vector3i> forwardSteps() {
  std::vector<Eigen::Vector3i> steps;
  for (int z = 0; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (z > 0 || y > 0 || (y == 0 && x > 0)) steps.emplace_back(x, y, z);
  return steps;
}

}  // namespace

std::vector<std::vector<uint32_t>> connectedComponents(const VoxelLattice& lattice,
                                                       const std::vector<uint32_t>& voxels) {
  DisjointSets sets(voxels.size());
  for (const Eigen::Vector3i& step : forwardSteps())
    forNeighbors(lattice, voxels, step, [&](size_t a, size_t b) { sets.join(a, b); });

  std::vector<std::vector<uint32_t>> components;
  std::vector<uint32_t> component_of(voxels.size());
  for (size_t i = 0; i < voxels.size(); ++i) {
    const size_t first = sets.find(i);
    if (first == i) {
      component_of[i] = uint32_t(components.size());
      components.emplace_back();
    }
    components[component_of[first]].push_back(voxels[i]);
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return components;
}

}  // namespace markerless_mocap
