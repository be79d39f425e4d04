#pragma once

#include <cstdint>
#include <vector>

#include "hull/voting/leaf_volume.h"

namespace markerless_mocap {

/// Voxels of one leaf.
struct Cell {
  uint32_t leaf;
  uint64_t voxels;
};

/// A set of voxels: its leaves in ascending order, none of them empty.
struct Piece {
  std::vector<Cell> cells;
  size_t voxels = 0;
  bool suspect_ghost = false;

  void add(uint32_t leaf, uint64_t bits) {
    cells.push_back({leaf, bits});
    voxels += size_t(__builtin_popcountll(bits));
  }
};

/// A voxel of a piece.
struct PieceVoxel {
  uint32_t index;  ///< linear, in the lattice
  uint32_t slot;   ///< 64 * cell + bit
};

/// Lattice coordinates of the lowest voxel of a leaf.
Eigen::Vector3i cornerOf(const VoxelLattice& lattice, uint32_t leaf);

/// Cells [begin, end) of a piece whose leaves are of one row along x, and that row's place.
struct CellRow {
  size_t begin, end;
  int y, z;  ///< leaves
};
std::vector<CellRow> rowsOf(const Piece& piece, const Eigen::Vector3i& leaves);

/// Calls visit(linear index, slot) for the piece's voxels in the order of their indices.
template <class Visit>
void forEachInLatticeOrder(const Piece& piece, const VoxelLattice& lattice, Visit visit) {
  const Eigen::Vector3i size = leavesOf(lattice);
  const std::vector<CellRow> rows = rowsOf(piece, size);
  const auto visit_line = [&](const CellRow& row, int y, int z) {
    const uint32_t row_start = uint32_t((row.z * size.y() + row.y) * size.x());
    const uint32_t line = lattice.index(0, kLeaf * row.y + y, kLeaf * row.z + z);
    const uint32_t shift = uint32_t(4 * y + 16 * z);
    for (size_t c = row.begin; c < row.end; ++c) {
      const uint32_t first = line + kLeaf * (piece.cells[c].leaf - row_start);
      const uint32_t slot = uint32_t(64 * c) + shift;
      const uint32_t bits = uint32_t(piece.cells[c].voxels >> shift) & 15;
      if (bits == 15)  // as nearly everywhere
        for (uint32_t i = 0; i < kLeaf; ++i) visit(first + i, slot + i);
      else
        for (uint32_t i = 0; i < kLeaf; ++i)
          if (bits >> i & 1) visit(first + i, slot + i);
    }
  };
  for (size_t begin = 0, end; begin < rows.size(); begin = end) {
    for (end = begin; end < rows.size() && rows[end].z == rows[begin].z;) ++end;
    for (int z = 0; z < kLeaf; ++z)
      for (size_t row = begin; row < end; ++row)
        for (int y = 0; y < kLeaf; ++y) visit_line(rows[row], y, z);
  }
}

/// The piece's voxels sorted by linear index.
std::vector<PieceVoxel> inLatticeOrder(const Piece& piece, const VoxelLattice& lattice);

/// The least box around the piece.
VoxelBox boxOf(const Piece& piece, const VoxelLattice& lattice);

/// The union of cells in any order, leaves in any number of cells.
Piece unionOf(std::vector<Cell> cells);

}  // namespace markerless_mocap
