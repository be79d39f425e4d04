#include "skeleton/tree_volume.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {

namespace {

/// Calls with x and the row (y + size.y * z) of each voxel; voxels ascend, so no division is needed
/// from one to the next.
template <class Visit>
void visitVoxels(const VisualHull& hull, const Visit& visit) {
  const uint32_t length = uint32_t(hull.lattice.size.x());
  uint32_t row = 0, start = 0;
  for (const HullVoxel& voxel : hull.voxels) {
    if (voxel.index - start >= 16 * length) {
      row = voxel.index / length;
      start = row * length;
    }
    for (; voxel.index - start >= length; start += length) ++row;
    visit(int(voxel.index - start), row);
  }
}

}  // namespace

TreeVolume::TreeVolume(const VisualHull& hull) : lattice_(hull.lattice) {
  if (hull.voxels.empty()) return;
  const uint32_t rows = uint32_t(lattice_.size.y());
  lowest_ = lattice_.coordinates(hull.voxels.front().index);
  Eigen::Vector3i highest = lattice_.coordinates(hull.voxels.back().index);
  uint32_t last_row = ~0u;
  visitVoxels(hull, [&](int x, uint32_t row) {
    lowest_.x() = std::min(lowest_.x(), x);
    highest.x() = std::max(highest.x(), x);
    if (row == last_row) return;
    last_row = row;
    lowest_.y() = std::min(lowest_.y(), int(row % rows));
    highest.y() = std::max(highest.y(), int(row % rows));
  });
  size_ = highest - lowest_ + Eigen::Vector3i::Ones();
  bits_.assign((size_t(size_.x()) * size_.y() * size_.z() >> 6) + 1, 0);
  size_t base = 0;
  last_row = ~0u;
  visitVoxels(hull, [&](int x, uint32_t row) {
    if (row != last_row) {
      last_row = row;
      const size_t y = row % rows - uint32_t(lowest_.y()), z = row / rows - uint32_t(lowest_.z());
      base = (z * size_t(size_.y()) + y) * size_t(size_.x());
    }
    const size_t bit = base + size_t(x - lowest_.x());
    bits_[bit >> 6] |= uint64_t(1) << (bit & 63);
  });
}

double TreeVolume::thickness(const Eigen::Vector3i& voxel) const {
  double least = 1e9;
  for (int code = 0; code < 27; ++code) {
    if (code == 13) continue;
    const Eigen::Vector3i step(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
    const double length = std::sqrt(double(step.squaredNorm()));
    Eigen::Vector3i at = voxel + step;
    double way = 0.5 * length;
    while (way < least && inside(at)) {
      at += step;
      way += length;
    }
    least = std::min(least, way);
  }
  return least * lattice_.pitch;
}

double TreeVolume::wayOut(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                          double most) const {
  const double step = 0.25 * lattice_.pitch;
  double way = 0.0;
  while (way + step <= most) {
    const Eigen::Vector3d at = (from + (way + step) * direction - lattice_.origin) / lattice_.pitch;
    if (!inside(at.array().floor().matrix().cast<int>())) break;
    way += step;
  }
  return way;
}

std::vector<Eigen::Vector3d> TreeVolume::near(const Eigen::Vector3d& point, double distance,
                                              double height) const {
  std::vector<Eigen::Vector3d> found;
  const Eigen::Vector3i middle =
      ((point - lattice_.origin) / lattice_.pitch).array().floor().matrix().cast<int>();
  const int reach = int(std::ceil(distance / lattice_.pitch));
  for (int z = middle.z() - reach; z <= middle.z() + reach; ++z) {
    for (int y = middle.y() - reach; y <= middle.y() + reach; ++y) {
      for (int x = middle.x() - reach; x <= middle.x() + reach; ++x) {
        const Eigen::Vector3i at(x, y, z);
        const Eigen::Vector3d p =
            lattice_.origin + lattice_.pitch * (at.cast<double>().array() + 0.5).matrix();
        if (p.z() <= height && (p - point).norm() <= distance && inside(at)) found.push_back(p);
      }
    }
  }
  return found;
}

}  // namespace markerless_mocap
