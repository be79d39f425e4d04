#pragma once

#include <cstdint>
#include <vector>

#include "hull/voting/brick_volume.h"

namespace markerless_mocap {

/// A second component counts as a second body if it has so many litres, and at least this fraction
/// of the first one's.
constexpr double kSecondBodyFraction = 0.4;
constexpr double kSecondBodyLitres = 15.0;

/// Voxels of one brick.
struct BrickVoxels {
  uint32_t brick;
  uint64_t voxels;
};

/// A set of voxels: its bricks in ascending order, none of them empty.
struct VoxelComponent {
  std::vector<BrickVoxels> cells;
  size_t voxels = 0;
  bool suspect_ghost = false, unsure = false;  ///< as in HullComponent

  void add(uint32_t brick, uint64_t bits) {
    cells.push_back({brick, bits});
    voxels += size_t(__builtin_popcountll(bits));
  }
};

/// A voxel of a component.
struct ComponentVoxel {
  uint32_t index;  ///< linear, in the lattice
  uint32_t slot;   ///< 64 * cell + bit
};

/// Lattice coordinates of the first voxel of a brick.
Eigen::Vector3i cornerOf(const VoxelLattice& lattice, uint32_t brick);

/// Cells [begin, end) of a component whose bricks lie in one row along x, and the position of that
/// row.
struct CellRow {
  size_t begin, end;
  int y, z;  ///< bricks
};
std::vector<CellRow> rowsOf(const VoxelComponent& component, const Eigen::Vector3i& bricks);

/// Calls visit(linear index, slot) for the component's voxels in the order of their indices.
template <class Visit>
void forEachInLatticeOrder(const VoxelComponent& component, const VoxelLattice& lattice,
                           Visit visit) {
  const Eigen::Vector3i size = bricksOf(lattice);
  const std::vector<CellRow> rows = rowsOf(component, size);
  const auto visit_line = [&](const CellRow& row, int y, int z) {
    const uint32_t row_start = uint32_t((row.z * size.y() + row.y) * size.x());
    const uint32_t line = lattice.index(0, kBrickSide * row.y + y, kBrickSide * row.z + z);
    const uint32_t shift = uint32_t(4 * y + 16 * z);
    for (size_t c = row.begin; c < row.end; ++c) {
      const uint32_t first = line + kBrickSide * (component.cells[c].brick - row_start);
      const uint32_t slot = uint32_t(64 * c) + shift;
      const uint32_t bits = uint32_t(component.cells[c].voxels >> shift) & 15;
      if (bits == 15)  // the most common case
        for (uint32_t i = 0; i < kBrickSide; ++i) visit(first + i, slot + i);
      else
        for (uint32_t i = 0; i < kBrickSide; ++i)
          if (bits >> i & 1) visit(first + i, slot + i);
    }
  };
  for (size_t begin = 0, end; begin < rows.size(); begin = end) {
    for (end = begin; end < rows.size() && rows[end].z == rows[begin].z;) ++end;
    for (int z = 0; z < kBrickSide; ++z)
      for (size_t row = begin; row < end; ++row)
        for (int y = 0; y < kBrickSide; ++y) visit_line(rows[row], y, z);
  }
}

/// The component's voxels sorted by linear index.
std::vector<ComponentVoxel> inLatticeOrder(const VoxelComponent& component,
                                           const VoxelLattice& lattice);

/// The bounding box of the component.
VoxelBox boxOf(const VoxelComponent& component, const VoxelLattice& lattice);

/// Number of voxels that are in both components.
size_t commonVoxels(const VoxelComponent& one, const VoxelComponent& other);

/// The union of cells, given in any order; a brick may have several cells.
VoxelComponent unionOf(std::vector<BrickVoxels> cells);

}  // namespace markerless_mocap
