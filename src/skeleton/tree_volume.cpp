#include "skeleton/tree_volume.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {

TreeVolume::TreeVolume(const VisualHull& hull) : lattice_(hull.lattice) {
  if (hull.voxels.empty()) return;
  Eigen::Vector3i highest = lattice_.coordinates(hull.voxels.front().index);
  lowest_ = highest;
  std::vector<Eigen::Vector3i> at;
  at.reserve(hull.voxels.size());
  for (const HullVoxel& voxel : hull.voxels) {
    at.push_back(lattice_.coordinates(voxel.index));
    lowest_ = lowest_.cwiseMin(at.back());
    highest = highest.cwiseMax(at.back());
  }
  size_ = highest - lowest_ + Eigen::Vector3i::Ones();
  bits_.assign((size_t(size_.x()) * size_.y() * size_.z() >> 6) + 1, 0);
  for (const Eigen::Vector3i& voxel : at) {
    const Eigen::Vector3i c = voxel - lowest_;
    const size_t bit = (size_t(c.z()) * size_.y() + c.y()) * size_.x() + c.x();
    bits_[bit >> 6] |= uint64_t(1) << (bit & 63);
  }
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

}  // namespace markerless_mocap
