#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Replaces each value by the minimum over the grid of value' + squared distance to it, in cells
/// (Felzenszwalb and Huttenlocher 2012). x varies fastest.
void squaredDistanceTransform(std::vector<float>& values, const Eigen::Vector3i& size);

/// Signed distance to the surface of a hull, and its surface voxels.
class HullDistanceField {
 public:
  /// \param hull at least one voxel
  explicit HullDistanceField(const VisualHull& hull);

  /// Metres, negative inside, trilinear between voxel centres. Outside the cropped grid: the value
  /// at its border plus the distance to the border.
  double signedDistance(const Eigen::Vector3d& point) const;

  /// Voxels of the hull (indices into VisualHull::voxels) with an empty 6-neighbour.
  const std::vector<uint32_t>& surface() const { return surface_; }

 private:
  void crop(const VisualHull& hull);
  void findSurface(const VisualHull& hull, const std::vector<uint8_t>& filled);
  size_t cell(const Eigen::Vector3i& c) const {
    return (size_t(c.z()) * size_.y() + c.y()) * size_.x() + c.x();
  }

  Eigen::Vector3d first_center_;
  double pitch_;
  Eigen::Vector3i corner_, size_;  // of the cropped grid, in voxels
  std::vector<float> distance_;
  std::vector<uint32_t> surface_;
};

}  // namespace markerless_mocap
