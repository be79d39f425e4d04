#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Directions of a camera's viewing rays, interpolated linearly in a table of undistorted points:
/// exact without distortion, else within some hundredths of a pixel.
class RayTable {
 public:
  explicit RayTable(const Camera& camera);
  /// Direction in the world, not normalised. \param pixel inside the image
  Eigen::Vector3d direction(const Eigen::Vector2d& pixel) const;

 private:
  static constexpr int kStep = 8;  ///< pixels between nodes
  int columns_, rows_;
  bool wide_;  ///< whether the nodes are stereographic, as a fisheye sees beside itself
  std::vector<Eigen::Vector2d> nodes_;  ///< undistorted, on the plane at depth 1
  Eigen::Matrix3d R_world_camera_;
};

}  // namespace markerless_mocap
