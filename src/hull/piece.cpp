#include "hull/piece.h"

#include <algorithm>
#include <limits>

namespace markerless_mocap {
namespace {

/// Cells [begin, end) whose leaves are of one row along x, and that row's place.
struct CellRow {
  size_t begin, end;
  int y, z;  ///< leaves
};

std::vector<CellRow> rowsOf(const Piece& piece, const Eigen::Vector3i& size) {
  std::vector<CellRow> rows;
  uint32_t row_end = 0;  // first leaf of the next row
  for (size_t i = 0; i < piece.cells.size(); ++i) {
    const uint32_t leaf = piece.cells[i].leaf;
    if (rows.empty() || leaf >= row_end) {
      const uint32_t row = leaf / uint32_t(size.x());
      row_end = (row + 1) * uint32_t(size.x());
      rows.push_back({i, i, int(row % uint32_t(size.y())), int(row / uint32_t(size.y()))});
    }
    rows.back().end = i + 1;
  }
  return rows;
}

}  // namespace

Eigen::Vector3i cornerOf(const VoxelLattice& lattice, uint32_t leaf) {
  const Eigen::Vector3i size = leavesOf(lattice);
  return kLeaf * Eigen::Vector3i(int(leaf) % size.x(), int(leaf) / size.x() % size.y(),
                                 int(leaf) / (size.x() * size.y()));
}

std::vector<PieceVoxel> inLatticeOrder(const Piece& piece, const VoxelLattice& lattice) {
  const Eigen::Vector3i size = leavesOf(lattice);
  const std::vector<CellRow> rows = rowsOf(piece, size);
  std::vector<PieceVoxel> voxels;
  voxels.reserve(piece.voxels);
  const auto list_line = [&](const CellRow& row, int y, int z) {
    const uint32_t line = lattice.index(0, kLeaf * row.y + y, kLeaf * row.z + z);
    const uint32_t row_start = uint32_t((row.z * size.y() + row.y) * size.x());
    const int shift = 4 * y + 16 * z;
    for (size_t c = row.begin; c < row.end; ++c) {
      const uint32_t x = kLeaf * (piece.cells[c].leaf - row_start);
      for (uint32_t bits = piece.cells[c].voxels >> shift & 15; bits != 0; bits &= bits - 1) {
        const uint32_t i = uint32_t(__builtin_ctz(bits));
        voxels.push_back({line + x + i, uint32_t(64 * c) + uint32_t(shift) + i});
      }
    }
  };
  for (size_t begin = 0, end; begin < rows.size(); begin = end) {
    for (end = begin; end < rows.size() && rows[end].z == rows[begin].z;) ++end;
    for (int z = 0; z < kLeaf; ++z)
      for (size_t row = begin; row < end; ++row)
        for (int y = 0; y < kLeaf; ++y) list_line(rows[row], y, z);
  }
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
