#include "markerless_mocap/skeleton/thinner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "skeleton/bit_volume_components.h"
#include "skeleton/cavity_filling.h"
#include "skeleton/simple_point.h"
#include "skeleton/thinning_scheme.h"

namespace markerless_mocap {
namespace {

struct Corners {
  Eigen::Vector3i low, high;
};

/// Calls visit(begin, end, x of begin, y, z) for the voxels of each row.
template <class Visit>
void forEachRow(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels, Visit visit) {
  const auto nx = uint32_t(lattice.size.x()), ny = uint32_t(lattice.size.y());
  for (auto begin = voxels.begin(); begin != voxels.end();) {
    const uint32_t row = *begin / nx, next_row = (row + 1) * nx;
    auto end = begin + 1;
    while (end != voxels.end() && *end < next_row) ++end;
    visit(begin, end, int(*begin - row * nx), int(row % ny), int(row / ny));
    begin = end;
  }
}

void check(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
  if (voxels.back() >= lattice.count()) {
    throw std::invalid_argument("voxel " + std::to_string(voxels.back()) +
                                " is beyond the lattice of " + std::to_string(lattice.count()));
  }
  bool ascending = true;
  for (size_t i = 1; i < voxels.size(); ++i) ascending &= voxels[i - 1] < voxels[i];
  if (!ascending)
    throw std::invalid_argument("voxels to thin must be in ascending order, each once");
}

Corners cornersOf(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
  Corners corners{lattice.size, Eigen::Vector3i::Zero()};
  forEachRow(lattice, voxels, [&](auto begin, auto end, int x, int y, int z) {
    corners.low = corners.low.cwiseMin(Eigen::Vector3i(x, y, z));
    const int last = x + int(*(end - 1) - *begin);
    corners.high = corners.high.cwiseMax(Eigen::Vector3i(last, y, z));
  });
  return corners;
}

}  // namespace

class Thinner::Workspace {
 public:
  explicit Workspace(double persistence) : persistence_(persistence) {
    if (!(persistence >= 0.0) || std::isinf(persistence)) {
      throw std::invalid_argument("the thinner's persistence must be >= 0 and finite, not " +
                                  std::to_string(persistence));
    }
  }

  CurveSkeleton thin(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
    CurveSkeleton skeleton;
    skeleton.lattice = lattice;
    if (voxels.empty()) return skeleton;
    check(lattice, voxels);
    load(lattice, voxels);
    const DroppedComponents dropped = components_.keep(box_, &object_);
    skeleton.components_dropped = dropped.components;
    skeleton.voxels_dropped = dropped.voxels;
    skeleton.voxels_filled = cavities_.fill(box_, &object_);
    peeling_.peel(box_, roundsIn(lattice.pitch), &object_);
    sides_.thin(box_, &object_);
    unload(lattice, &skeleton.voxels);
    return skeleton;
  }

  std::vector<uint32_t> voxels;

 private:
  int roundsIn(double pitch) const {
    return int(std::clamp(std::round(persistence_ / pitch), 1.0, 1000.0));
  }

  void load(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
    const Corners corners = cornersOf(lattice, voxels);
    low_ = corners.low;
    const Eigen::Vector3i size = corners.high - corners.low + Eigen::Vector3i::Ones();
    box_ = BitBox(size.x(), size.y(), size.z());
    object_.assign(box_.words, 0);
    forEachRow(lattice, voxels, [&](auto begin, auto end, int x, int y, int z) {
      const size_t first = box_.bitOf(x - low_.x(), y - low_.y(), z - low_.z()) - *begin;
      size_t word = (first + *begin) / 64;
      uint64_t bits = 0;
      for (auto voxel = begin; voxel != end; ++voxel) {
        const size_t bit = first + *voxel;
        if (bit / 64 != word) {
          object_[word] = bits;
          bits = 0;
          word = bit / 64;
        }
        bits |= uint64_t(1) << (bit % 64);
      }
      object_[word] = bits;
    });
  }

  void unload(const VoxelLattice& lattice, std::vector<uint32_t>* voxels) const {
    for (int z = 0; z < box_.nz; ++z) {
      for (int y = 0; y < box_.ny; ++y) {
        const size_t row = box_.wordOf(y + 1, z + 1);
        for (size_t w = 0; w < box_.row; ++w) {
          for (uint64_t left = object_[row + w]; left != 0; left &= left - 1) {
            const int x = int(w) * 64 + __builtin_ctzll(left) - 1;
            voxels->push_back(lattice.index(x + low_.x(), y + low_.y(), z + low_.z()));
          }
        }
      }
    }
  }

  double persistence_;
  Eigen::Vector3i low_;
  BitBox box_;
  BitWords object_;
  LargestComponent components_;
  CavityFiller cavities_;
  SymmetricPeeling peeling_;
  SideThinning sides_;
};

Thinner::Thinner(double persistence) : workspace_(std::make_unique<Workspace>(persistence)) {
  SimplePointTable::shared();
}
Thinner::~Thinner() = default;
Thinner::Thinner(Thinner&&) noexcept = default;
Thinner& Thinner::operator=(Thinner&&) noexcept = default;

CurveSkeleton Thinner::thin(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
  return workspace_->thin(lattice, voxels);
}

CurveSkeleton Thinner::thin(const VisualHull& hull) {
  std::vector<uint32_t>& voxels = workspace_->voxels;
  voxels.clear();
  for (const HullVoxel& voxel : hull.voxels) voxels.push_back(voxel.index);
  return workspace_->thin(hull.lattice, voxels);
}

CurveSkeleton thinToCurves(const VisualHull& hull) {
  return Thinner().thin(hull);
}

}  // namespace markerless_mocap
