#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// The voxels of a hull as bits of their bounding box; measures how thick the body is at a point.
class TreeVolume {
 public:
  explicit TreeVolume(const VisualHull& hull);

  double pitch() const { return lattice_.pitch; }
  bool inside(const Eigen::Vector3i& at) const {
    const Eigen::Vector3i c = at - low_;
    if ((c.array() < 0).any() || (c.array() >= size_.array()).any()) return false;
    const size_t bit = (size_t(c.z()) * size_.y() + c.y()) * size_.x() + c.x();
    return (bits_[bit >> 6] >> (bit & 63)) & 1u;
  }
  /// Shortest distance from the centre of a voxel to the outside of the hull along the 26
  /// directions to its neighbours, metres; up to 12 % more than the distance to a flat surface.
  double thickness(const Eigen::Vector3i& voxel) const;
  double thickness(uint32_t voxel) const { return thickness(lattice_.coordinates(voxel)); }
  double thickness(const Eigen::Vector3d& point) const {
    return thickness(
        ((point - lattice_.origin) / lattice_.pitch).array().floor().matrix().cast<int>().eval());
  }
  /// Distance from a point along a unit vector to the last voxel of the hull before the first gap,
  /// up to `max_distance`, metres.
  double distanceToSurface(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                           double max_distance) const;

  /// Centres of the hull's voxels within a distance of a point and below a height, metres.
  std::vector<Eigen::Vector3d> near(const Eigen::Vector3d& point, double distance,
                                    double height) const;

 private:
  VoxelLattice lattice_;
  Eigen::Vector3i low_ = Eigen::Vector3i::Zero(), size_ = Eigen::Vector3i::Zero();
  std::vector<uint64_t> bits_;
};

}  // namespace markerless_mocap
