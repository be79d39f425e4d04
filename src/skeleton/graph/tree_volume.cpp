#include "skeleton/graph/tree_volume.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {

namespace {

/// Neighbouring voxels of one row.
struct Run {
  int x, y, z;
  uint32_t length;
};

/// Voxels are in ascending order. If the voxel `kStride` entries later has an index that is larger
/// by `kStride`, all voxels in between are in the hull as well.
std::vector<Run> runsOf(const VisualHull& hull) {
  constexpr size_t kStride = 8;
  const std::vector<HullVoxel>& voxels = hull.voxels;
  std::vector<Run> runs;
  for (size_t i = 0; i < voxels.size();) {
    const uint32_t first = voxels[i].index;
    const Eigen::Vector3i at = hull.lattice.coordinates(first);
    const size_t most = std::min(voxels.size() - i, size_t(hull.lattice.size.x() - at.x()));
    size_t length = 1;
    const auto reaches = [&](size_t n) {
      return n <= most && voxels[i + n - 1].index - first == uint32_t(n - 1);
    };
    while (reaches(length + kStride)) length += kStride;
    while (reaches(length + 1)) ++length;
    runs.push_back({at.x(), at.y(), at.z(), uint32_t(length)});
    i += length;
  }
  return runs;
}

void setBits(size_t from, size_t count, std::vector<uint64_t>* bits) {
  while (count > 0) {
    const size_t offset = from & 63, taken = std::min(count, 64 - offset);
    (*bits)[from >> 6] |= (~uint64_t(0) >> (64 - taken)) << offset;
    from += taken;
    count -= taken;
  }
}

}  // namespace

TreeVolume::TreeVolume(const VisualHull& hull) : lattice_(hull.lattice) {
  if (hull.voxels.empty()) return;
  const std::vector<Run> runs = runsOf(hull);
  low_ = lattice_.size;
  Eigen::Vector3i highest = Eigen::Vector3i::Zero();
  for (const Run& run : runs) {
    low_ = low_.cwiseMin(Eigen::Vector3i(run.x, run.y, run.z));
    highest = highest.cwiseMax(Eigen::Vector3i(run.x + int(run.length) - 1, run.y, run.z));
  }
  size_ = highest - low_ + Eigen::Vector3i::Ones();
  bits_.assign((size_t(size_.x()) * size_.y() * size_.z() >> 6) + 1, 0);
  for (const Run& run : runs) {
    const size_t row = size_t(run.z - low_.z()) * size_.y() + (run.y - low_.y());
    setBits(row * size_.x() + (run.x - low_.x()), run.length, &bits_);
  }
}

double TreeVolume::thickness(const Eigen::Vector3i& voxel) const {
  double min_length = 1e9;
  for (int code = 0; code < 27; ++code) {
    if (code == 13) continue;
    const Eigen::Vector3i step(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
    const double length = std::sqrt(double(step.squaredNorm()));
    Eigen::Vector3i at = voxel + step;
    double path_length = 0.5 * length;
    while (path_length < min_length && inside(at)) {
      at += step;
      path_length += length;
    }
    min_length = std::min(min_length, path_length);
  }
  return min_length * lattice_.pitch;
}

double TreeVolume::distanceToSurface(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                     double most) const {
  const double step = 0.25 * lattice_.pitch;
  double path_length = 0.0;
  while (path_length + step <= most) {
    const Eigen::Vector3d at =
        (from + (path_length + step) * direction - lattice_.origin) / lattice_.pitch;
    if (!inside(at.array().floor().matrix().cast<int>())) break;
    path_length += step;
  }
  return path_length;
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
