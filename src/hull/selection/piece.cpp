#include "hull/selection/piece.h"

#include <algorithm>
#include <limits>

namespace markerless_mocap {

std::vector<CellRow> rowsOf(const Piece& piece, const Eigen::Vector3i& leaves) {
  std::vector<CellRow> rows;
  uint32_t row_end = 0;  // first leaf of the next row
  for (size_t i = 0; i < piece.cells.size(); ++i) {
    const uint32_t leaf = piece.cells[i].leaf;
    if (rows.empty() || leaf >= row_end) {
      const uint32_t row = leaf / uint32_t(leaves.x());
      row_end = (row + 1) * uint32_t(leaves.x());
      rows.push_back({i, i, int(row % uint32_t(leaves.y())), int(row / uint32_t(leaves.y()))});
    }
    rows.back().end = i + 1;
  }
  return rows;
}

Eigen::Vector3i cornerOf(const VoxelLattice& lattice, uint32_t leaf) {
  const Eigen::Vector3i size = leavesOf(lattice);
  return kLeaf * Eigen::Vector3i(int(leaf) % size.x(), int(leaf) / size.x() % size.y(),
                                 int(leaf) / (size.x() * size.y()));
}

std::vector<PieceVoxel> inLatticeOrder(const Piece& piece, const VoxelLattice& lattice) {
  std::vector<PieceVoxel> voxels;
  voxels.reserve(piece.voxels);
  forEachInLatticeOrder(piece, lattice, [&](uint32_t index, uint32_t slot) {
    voxels.push_back({index, slot});
  });
  return voxels;
}

VoxelBox boxOf(const Piece& piece, const VoxelLattice& lattice) {
  VoxelBox box;
  box.low.setConstant(std::numeric_limits<int>::max());
  box.high.setConstant(std::numeric_limits<int>::min());
  for (const Cell& cell : piece.cells) {
    const Eigen::Vector3i corner = cornerOf(lattice, cell.leaf);
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kLeaf; ++i)
        if (cell.voxels & leaf_words::slab(axis, i, i + 1)) {
          box.low[axis] = std::min(box.low[axis], corner[axis] + i);
          box.high[axis] = std::max(box.high[axis], corner[axis] + i + 1);
        }
  }
  return box;
}

Piece unionOf(std::vector<Cell> cells) {
  std::sort(cells.begin(), cells.end(),
            [](const Cell& a, const Cell& b) { return a.leaf < b.leaf; });
  Piece piece;
  for (size_t i = 0; i < cells.size();) {
    uint64_t voxels = 0;
    const uint32_t leaf = cells[i].leaf;
    for (; i < cells.size() && cells[i].leaf == leaf; ++i) voxels |= cells[i].voxels;
    piece.add(leaf, voxels);
  }
  return piece;
}

}  // namespace markerless_mocap
