#pragma once

#include <optional>

#include "hull/voting/brick_words.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

/// A voxel of a brick and the pixel at which a camera sees it.
struct VoxelPixel {
  int voxel;  ///< bit of the brick's word
  int x, y;
};

/// Projects the centres of a brick's voxels: as Camera::projectInside(), but for a polynomial lens
/// all voxels at once, in vectors.
class BrickProjection {
 public:
  static constexpr int kVoxels = kBrickSide * kBrickSide * kBrickSide;

  /// \param camera and \param lattice must outlive this object
  BrickProjection(const Camera& camera, const VoxelLattice& lattice);

  /// The pixels of the voxels that the camera sees; returns their number.
  /// \param corner coordinates of the brick's first voxel
  int project(const Eigen::Vector3i& corner, VoxelPixel (&pixels)[kVoxels]) const;

 private:
  /// The voxels' centres, and what a polynomial lens makes of them.
  struct Points {
    double x[kVoxels], y[kVoxels], z[kVoxels];       ///< world, metres
    double depth[kVoxels], squared_radius[kVoxels];  ///< in the camera; in the image plane
    double distorted_x[kVoxels], distorted_y[kVoxels];
  };
  std::optional<Eigen::Vector2d> pixelOf(const Points& points, int i) const;

  const Camera& camera_;
  const VoxelLattice& lattice_;
  LensNumbers lens_;
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> to_camera_;  ///< from the world
};

}  // namespace markerless_mocap
