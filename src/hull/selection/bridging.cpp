#include "hull/selection/bridging.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kMaxBridgeLength = 0.5;  // m
/// A bridge consists of the voxels on paths that are longer than the shortest by up to this, m.
constexpr double kDetour = 0.12;
constexpr int16_t kOutside = -2, kUnreached = -1;

/// Voxels of a box with a margin of one, so that every voxel of the box has 26 neighbours.
class BoxGrid {
 public:
  BoxGrid(const VoxelBox& box, const VoxelLattice& lattice)
      : box_(box), lattice_(lattice), size_((box.high - box.low).array() + 2) {
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (x != 0 || y != 0 || z != 0) neighbors_.push_back((z * size_.y() + y) * size_.x() + x);
  }

  size_t count() const { return size_t(size_.prod()); }
  const std::vector<int>& neighbors() const { return neighbors_; }

  /// Calls visit(index in the grid, bit) for the cell's voxels in the box.
  template <class Visit>
  void forEach(const BrickVoxels& cell, Visit visit) const {
    const Eigen::Vector3i corner = cornerOf(lattice_, cell.brick);
    for (uint64_t left = cell.voxels & brick_words::inside(box_, corner); left != 0;
         left &= left - 1) {
      const int bit = __builtin_ctzll(left);
      const Eigen::Vector3i at =
          corner - box_.low + Eigen::Vector3i((bit & 3) + 1, (bit >> 2 & 3) + 1, (bit >> 4) + 1);
      visit(size_t(at.z() * size_.y() + at.y()) * size_.x() + at.x(), bit);
    }
  }

 private:
  VoxelBox box_;
  const VoxelLattice& lattice_;
  Eigen::Vector3i size_;
  std::vector<int> neighbors_;
};

/// Number of steps between 26-neighbours from the nearest voxel of `from`, within `ground`; up to
/// `max_steps`.
std::vector<int16_t> stepsFrom(const BoxGrid& grid, const std::vector<BrickVoxels>& ground,
                               const VoxelComponent& from, int max_steps) {
  std::vector<int16_t> steps(grid.count(), kOutside);
  std::vector<size_t> front, next;
  for (const BrickVoxels& cell : ground)
    grid.forEach(cell, [&](size_t at, int) { steps[at] = kUnreached; });
  for (const BrickVoxels& cell : from.cells)
    grid.forEach(cell, [&](size_t at, int) {
      steps[at] = 0;
      front.push_back(at);
    });
  for (int step = 1; step <= max_steps && !front.empty(); ++step, front.swap(next), next.clear())
    for (const size_t voxel : front)
      for (const int neighbor : grid.neighbors()) {
        int16_t& there = steps[size_t(int64_t(voxel) + neighbor)];
        if (there != kUnreached) continue;
        there = int16_t(step);
        next.push_back(size_t(int64_t(voxel) + neighbor));
      }
  return steps;
}

}  // namespace

VoxelComponent ComponentBridging::joined(const std::vector<VoxelComponent>& components,
                                         const VoxelComponent& body,
                                         const VoxelComponent& component) const {
  const int max_steps = int(std::lround((kMaxBridgeLength + kDetour) / lattice_.pitch));
  // A path of a bridge does not lead further away from the component than its length.
  VoxelBox box = boxOf(component, lattice_);
  box.low = (box.low.array() - max_steps).max(0);
  box.high = (box.high.array() + max_steps).min(lattice_.size.array());
  std::vector<BrickVoxels> ground = body.cells;
  for (const VoxelComponent& other : components)
    ground.insert(ground.end(), other.cells.begin(), other.cells.end());
  const BrickVolume& relaxed = relaxed_vote_(box);
  relaxed.forEachBrick([&](int, int, int, size_t brick) {
    ground.push_back({uint32_t(brick), relaxed.word(brick)});
  });

  const BoxGrid grid(box, lattice_);
  const std::vector<int16_t> from_body = stepsFrom(grid, ground, body, max_steps);
  const std::vector<int16_t> from_component = stepsFrom(grid, ground, component, max_steps);
  int shortest = max_steps + 1;
  for (const BrickVoxels& cell : component.cells)
    grid.forEach(cell, [&](size_t at, int) {
      if (from_body[at] >= 0) shortest = std::min<int>(shortest, from_body[at]);
    });
  if (shortest * lattice_.pitch > kMaxBridgeLength) return {};
  const int longest = shortest + int(std::lround(kDetour / lattice_.pitch));
  std::vector<BrickVoxels> both = body.cells;
  both.insert(both.end(), component.cells.begin(), component.cells.end());
  for (const BrickVoxels& cell : ground)
    grid.forEach(cell, [&](size_t at, int bit) {
      const int a = from_body[at], b = from_component[at];
      if (a > 0 && b > 0 && a + b <= longest) both.push_back({cell.brick, uint64_t(1) << bit});
    });
  return unionOf(std::move(both));
}

std::vector<VoxelComponent> ComponentBridging::bridge(std::vector<VoxelComponent> components,
                                                      size_t min_voxels) const {
  const std::vector<VoxelComponent> ground = components;
  std::vector<VoxelComponent> result;
  for (VoxelComponent& component : components) {
    VoxelComponent both;
    const bool may_belong = !component.suspect_ghost && component.voxels >= min_voxels;
    if (!result.empty() && may_belong) both = joined(ground, result[0], component);
    if (both.voxels == 0)
      result.push_back(std::move(component));
    else
      result[0] = std::move(both);
  }
  return result;
}

}  // namespace markerless_mocap
