#pragma once

#include <cstdint>
#include <vector>

#include "hull/leaf_volume.h"

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

/// The piece's voxels sorted by linear index.
std::vector<PieceVoxel> inLatticeOrder(const Piece& piece, const VoxelLattice& lattice);

/// The least box around the piece.
VoxelBox boxOf(const Piece& piece, const VoxelLattice& lattice);

/// The union of cells in any order, leaves in any number of cells.
Piece unionOf(std::vector<Cell> cells);

}  // namespace markerless_mocap
