#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The rays of a camera at twice the pixels' density: grid place (2 x + 1, 2 y + 1) is the centre
/// of pixel (x, y), its eight neighbours lie half a pixel away. Places are held as points of the
/// undistorted plane z = 1 before the camera, where straight edges are straight.
class SampleGrid {
 public:
  explicit SampleGrid(const Camera& camera);

  cv::Size size() const { return size_; }
  /// Points of row y, all of z = 1 in the camera's frame.
  const Eigen::Vector2f* row(int y) const { return &plane_[size_t(y) * size_.width]; }
  /// World to camera.
  const Eigen::Isometry3d& worldToCamera() const { return T_camera_world_; }

  /// Where a point (camera frame) falls on the grid; NaN when it is behind the camera or so far out
  /// that margin() does not hold for it.
  Eigen::Vector2d place(const Eigen::Vector3d& point) const;
  /// How far (grid steps) a triangle's points can stray from the box of its corners' places,
  /// because distortion bends edges. \param plane_size of the triangle's box in the plane z = 1
  double margin(double plane_size) const { return bend_ * plane_size * plane_size; }
  /// All places whose plane points may lie in a box of the plane.
  cv::Rect placesWithin(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

 private:
  struct Range {
    float low, high;
  };
  void computeRanges();
  double strongestBend() const;

  Camera camera_;
  Eigen::Isometry3d T_camera_world_;
  cv::Size size_;
  std::vector<Eigen::Vector2f> plane_;
  std::vector<Range> rows_, columns_;  ///< plane y of each row, plane x of each column
  Eigen::Vector2d low_, high_;         ///< of the plane points
  double farthest_squared_ = 0.0;      ///< from the axis, in the plane, with a reserve
  double bend_ = 0.0;
};

}  // namespace markerless_mocap
