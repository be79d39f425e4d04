#include "skeleton/thinning/bit_volume_window.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace markerless_mocap {
namespace {

void check(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
  if (voxels.back() >= lattice.count()) {
    throw std::invalid_argument("voxel " + std::to_string(voxels.back()) +
                                " is beyond the lattice of " + std::to_string(lattice.count()));
  }
  bool ascending = true;
  for (size_t i = 1; i < voxels.size(); ++i) ascending &= voxels[i - 1] < voxels[i];
  if (!ascending) throw std::invalid_argument("voxels must be in ascending order, each once");
}

}  // namespace

void BitVolumeWindow::listRows(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
  const auto nx = uint32_t(lattice.size.x()), ny = uint32_t(lattice.size.y());
  rows_.clear();
  for (size_t begin = 0; begin != voxels.size();) {
    const uint32_t row = voxels[begin] / nx, next_row = (row + 1) * nx;
    size_t end = begin + 1;
    while (end != voxels.size() && voxels[end] < next_row) ++end;
    rows_.push_back({begin, end, {int(voxels[begin] - row * nx), int(row % ny), int(row / ny)}});
    begin = end;
  }
}

void BitVolumeWindow::place(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
  Eigen::Vector3i high = Eigen::Vector3i::Zero();
  low_ = lattice.size;
  for (const Row& row : rows_) {
    const auto length = int(voxels[row.end - 1] - voxels[row.begin]);
    low_ = low_.cwiseMin(row.first);
    high = high.cwiseMax(row.first + length * Eigen::Vector3i::UnitX());
  }
  const Eigen::Vector3i size = high - low_ + Eigen::Vector3i::Ones();
  for (int axis = 0; axis < 3; ++axis) {
    const BitBox box(size[axis], size[(axis + 1) % 3], size[(axis + 2) % 3]);
    if (axis > 0 && box.words >= box_.words) continue;
    box_ = box;
    axis_ = axis;
  }
}

void BitVolumeWindow::load(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels,
                           BitWords* bits) {
  check(lattice, voxels);
  listRows(lattice, voxels);
  place(lattice, voxels);
  bits->assign(box_.words, 0);
  const size_t steps[3] = {1, box_.row * 64, box_.plane * 64};
  const size_t along_x = steps[(3 - axis_) % 3], along_y = steps[(4 - axis_) % 3];
  const size_t along_z = steps[(5 - axis_) % 3];
  for (const Row& row : rows_) {
    const Eigen::Vector3i at = row.first - low_;
    const size_t first = box_.bitOf(0, 0, 0) + size_t(at.x()) * along_x + size_t(at.y()) * along_y +
                         size_t(at.z()) * along_z;
    for (size_t i = row.begin; i != row.end; ++i)
      setBit(bits, first + (voxels[i] - voxels[row.begin]) * along_x);
  }
}

std::vector<uint32_t> BitVolumeWindow::unload(const VoxelLattice& lattice,
                                              const BitWords& bits) const {
  std::vector<uint32_t> voxels;
  forEachBit(box_, bits, [&](size_t bit) {
    const size_t word = bit / 64 - box_.guard;
    const size_t in_row = word % box_.plane % box_.row * 64 + bit % 64;
    Eigen::Vector3i at;
    at[axis_] = int(in_row) - 1;
    at[(axis_ + 1) % 3] = int(word % box_.plane / box_.row) - 1;
    at[(axis_ + 2) % 3] = int(word / box_.plane) - 1;
    at += low_;
    voxels.push_back(lattice.index(at.x(), at.y(), at.z()));
  });
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

}  // namespace markerless_mocap
