#include "hull/selection/components.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "numerics/disjoint_sets.h"

namespace markerless_mocap {
namespace {

uint32_t lowestVoxel(const VoxelComponent& component, const VoxelLattice& lattice) {
  uint32_t lowest = std::numeric_limits<uint32_t>::max();
  for (const BrickVoxels& cell : component.cells) {
    const int bit = __builtin_ctzll(cell.voxels);
    const Eigen::Vector3i at =
        cornerOf(lattice, cell.brick) + Eigen::Vector3i(bit & 3, bit >> 2 & 3, bit >> 4);
    lowest = std::min(lowest, lattice.index(at.x(), at.y(), at.z()));
  }
  return lowest;
}

}  // namespace

void ComponentFinder::listParts(const BrickVolume& volume) {
  parts_.clear();
  first_part_.resize(volume.count());
  volume.forEachBrick([&](int, int, int, size_t brick) {
    first_part_[brick] = uint32_t(parts_.size());
    for (uint64_t left = volume.word(brick); left != 0; left &= ~parts_.back().voxels)
      parts_.push_back({uint32_t(brick), brick_words::firstComponent(left)});
  });
  parents_.resize(parts_.size());
  std::iota(parents_.begin(), parents_.end(), 0u);
}

void ComponentFinder::joinTouching(uint32_t brick, uint32_t other, const int (&step)[3]) {
  for (uint32_t a = first_part_[brick]; a < parts_.size() && parts_[a].brick == brick; ++a)
    for (uint32_t b = first_part_[other]; parts_[b].brick == other; ++b) {
      const uint32_t of_a = rootOf(&parents_, a), of_b = rootOf(&parents_, b);
      if (of_a != of_b && (brick_words::touched(parts_[a].voxels, step) & parts_[b].voxels) != 0)
        joinSets(&parents_, of_a, of_b);
    }
}

void ComponentFinder::joinBackwards(const BrickVolume& volume, const Eigen::Vector3i& at,
                                    size_t brick) {
  // Neighbours across faces come first: parts that they join need no test across edges and corners.
  static constexpr int kSteps[13][3] = {
      {-1, 0, 0},  {0, -1, 0}, {0, 0, -1},   {-1, -1, 0}, {1, -1, 0},  {-1, 0, -1}, {1, 0, -1},
      {0, -1, -1}, {0, 1, -1}, {-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}};
  const Eigen::Vector3i& size = volume.size();
  for (const int(&step)[3] : kSteps) {
    const Eigen::Vector3i there = at + Eigen::Vector3i(step[0], step[1], step[2]);
    if ((there.array() < 0).any() || (there.array() >= size.array()).any()) continue;
    const size_t other = volume.brickAt(there.x(), there.y(), there.z());
    if (volume.word(other) != 0) joinTouching(uint32_t(brick), uint32_t(other), step);
  }
}

std::vector<VoxelComponent> ComponentFinder::find(const BrickVolume& volume,
                                                  const VoxelLattice& lattice) {
  listParts(volume);
  volume.forEachBrick([&](int x, int y, int z, size_t brick) {
    joinBackwards(volume, Eigen::Vector3i(x, y, z), brick);
  });
  std::vector<VoxelComponent> components;
  component_of_.resize(parts_.size());
  for (uint32_t part = 0; part < parts_.size(); ++part) {
    const uint32_t first = rootOf(&parents_, part);
    if (first == part) {
      component_of_[part] = uint32_t(components.size());
      components.emplace_back();
    }
    std::vector<BrickVoxels>& cells = components[component_of_[first]].cells;
    components[component_of_[first]].voxels += size_t(__builtin_popcountll(parts_[part].voxels));
    if (!cells.empty() && cells.back().brick == parts_[part].brick)
      cells.back().voxels |= parts_[part].voxels;
    else
      cells.push_back(parts_[part]);
  }
  // Most voxels first, then first voxel.
  std::vector<std::pair<std::pair<size_t, uint32_t>, size_t>> order;
  for (size_t i = 0; i < components.size(); ++i)
    order.push_back({{~components[i].voxels, lowestVoxel(components[i], lattice)}, i});
  std::sort(order.begin(), order.end());
  std::vector<VoxelComponent> sorted;
  for (const auto& entry : order) sorted.push_back(std::move(components[entry.second]));
  return sorted;
}

}  // namespace markerless_mocap
