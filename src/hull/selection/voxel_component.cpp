#include "hull/selection/voxel_component.h"

#include <algorithm>
#include <limits>

namespace markerless_mocap {

std::vector<CellRow> rowsOf(const VoxelComponent& component, const Eigen::Vector3i& bricks) {
  std::vector<CellRow> rows;
  uint32_t row_end = 0;  // first brick of the next row
  for (size_t i = 0; i < component.cells.size(); ++i) {
    const uint32_t brick = component.cells[i].brick;
    if (rows.empty() || brick >= row_end) {
      const uint32_t row = brick / uint32_t(bricks.x());
      row_end = (row + 1) * uint32_t(bricks.x());
      rows.push_back({i, i, int(row % uint32_t(bricks.y())), int(row / uint32_t(bricks.y()))});
    }
    rows.back().end = i + 1;
  }
  return rows;
}

Eigen::Vector3i cornerOf(const VoxelLattice& lattice, uint32_t brick) {
  const Eigen::Vector3i size = bricksOf(lattice);
  return kBrickSide * Eigen::Vector3i(int(brick) % size.x(), int(brick) / size.x() % size.y(),
                                      int(brick) / (size.x() * size.y()));
}

std::vector<ComponentVoxel> inLatticeOrder(const VoxelComponent& component,
                                           const VoxelLattice& lattice) {
  std::vector<ComponentVoxel> voxels;
  voxels.reserve(component.voxels);
  forEachInLatticeOrder(component, lattice, [&](uint32_t index, uint32_t slot) {
    voxels.push_back({index, slot});
  });
  return voxels;
}

VoxelBox boxOf(const VoxelComponent& component, const VoxelLattice& lattice) {
  VoxelBox box;
  box.low.setConstant(std::numeric_limits<int>::max());
  box.high.setConstant(std::numeric_limits<int>::min());
  for (const BrickVoxels& cell : component.cells) {
    const Eigen::Vector3i corner = cornerOf(lattice, cell.brick);
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kBrickSide; ++i)
        if (cell.voxels & brick_words::slab(axis, i, i + 1)) {
          box.low[axis] = std::min(box.low[axis], corner[axis] + i);
          box.high[axis] = std::max(box.high[axis], corner[axis] + i + 1);
        }
  }
  return box;
}

size_t commonVoxels(const VoxelComponent& one, const VoxelComponent& other) {
  size_t common = 0;
  auto b = other.cells.begin();
  for (const BrickVoxels& a : one.cells) {
    while (b != other.cells.end() && b->brick < a.brick) ++b;
    if (b == other.cells.end()) break;
    if (b->brick == a.brick) common += size_t(__builtin_popcountll(a.voxels & b->voxels));
  }
  return common;
}

VoxelComponent unionOf(std::vector<BrickVoxels> cells) {
  std::sort(cells.begin(), cells.end(),
            [](const BrickVoxels& a, const BrickVoxels& b) { return a.brick < b.brick; });
  VoxelComponent component;
  for (size_t i = 0; i < cells.size();) {
    uint64_t voxels = 0;
    const uint32_t brick = cells[i].brick;
    for (; i < cells.size() && cells[i].brick == brick; ++i) voxels |= cells[i].voxels;
    component.add(brick, voxels);
  }
  return component;
}

}  // namespace markerless_mocap
