#pragma once

#include <cmath>
#include <random>

#include "skeleton/thin_volume.h"

namespace markerless_mocap {

/// Voxels whose centre lies within `radius` of the line between two voxels' centres.
inline void addLimb(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                    ThinVolume* volume) {
  const Eigen::Vector3d axis = to - from;
  volume->fillWhere([&](int x, int y, int z) {
    const Eigen::Vector3d p(x, y, z);
    const double along = (p - from).dot(axis) / std::max(axis.squaredNorm(), 1e-9);
    return (p - from - std::clamp(along, 0.0, 1.0) * axis).norm() <= radius;
  });
}

/// Symmetric in x about the middle of the volume: arms out, legs apart, as a child draws them.
inline ThinVolume person() {
  ThinVolume volume(61, 17, 70);
  addLimb({30, 8, 34}, {30, 8, 50}, 6.5, &volume);
  addLimb({30, 8, 50}, {30, 8, 58}, 2.4, &volume);
  addLimb({30, 8, 63}, {30, 8, 63}, 4.6, &volume);
  for (int side : {-1, 1}) {
    addLimb({30.0 + side * 3, 8, 52}, {30.0 + side * 27, 8, 56}, 2.3, &volume);
    addLimb({30.0 + side * 4, 8, 32}, {30.0 + side * 8, 8, 3}, 3.2, &volume);
    addLimb({30.0 + side * 8, 8, 2}, {30.0 + side * 8, 3, 2}, 2.2, &volume);
  }
  return volume;
}

/// Limbs between random points, some of which meet in loops, with a noisy surface.
inline ThinVolume randomLimbs(std::mt19937* random, int nx, int ny, int nz) {
  ThinVolume volume(nx, ny, nz);
  const auto below = [&](int n) { return int((*random)() % uint32_t(n)); };
  Eigen::Vector3d from(below(nx), below(ny), below(nz));
  for (int limb = 0; limb < 6; ++limb) {
    const Eigen::Vector3d to(below(nx), below(ny), below(nz));
    addLimb(from, to, 1.0 + 0.5 * below(6), &volume);
    from = to;
  }
  for (int i = 0; i < nx * ny * nz / 60; ++i) {
    const int x = below(nx), y = below(ny), z = below(nz);
    if (volume.neighborCount(x, y, z) > 7) volume.set(x, y, z, below(2) == 0);
  }
  return volume;
}

/// Its mirror image across an axis.
inline ThinVolume mirrored(const ThinVolume& volume, int axis) {
  const Eigen::Vector3i n = volume.lattice.size;
  ThinVolume result(n.x(), n.y(), n.z());
  return result.fillWhere([&](int x, int y, int z) {
    Eigen::Vector3i p(x, y, z);
    p[axis] = n[axis] - 1 - p[axis];
    return volume.at(p.x(), p.y(), p.z());
  });
}

/// Largest step along an axis from a voxel of one to the nearest of the other, and back.
inline int distance(const ThinVolume& a, const ThinVolume& b) {
  const auto directedDistance = [](const ThinVolume& from, const ThinVolume& to) {
    int worst = 0;
    for (uint32_t i : from.voxels()) {
      int nearest = 1 << 20;
      for (uint32_t j : to.voxels()) {
        const Eigen::Vector3i apart = from.lattice.coordinates(i) - to.lattice.coordinates(j);
        nearest = std::min(nearest, apart.cwiseAbs().maxCoeff());
      }
      worst = std::max(worst, nearest);
    }
    return worst;
  };
  return std::max(directedDistance(a, b), directedDistance(b, a));
}

}  // namespace markerless_mocap
