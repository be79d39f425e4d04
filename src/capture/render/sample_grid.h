#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The rays of a camera at twice the density of its pixels: grid position (2 x + 1, 2 y + 1) is the
/// centre of pixel (x, y), and its eight neighbours are half a pixel away. Rays are stored as
/// points of the undistorted plane z = 1 in front of the camera, where straight edges are straight.
class SampleGrid {
 public:
  explicit SampleGrid(const Camera& camera);

  cv::Size size() const { return size_; }
  /// Points of row y, in the plane z = 1 of the camera's frame.
  const Eigen::Vector2f* row(int y) const { return &plane_[size_t(y) * size_.width]; }
  /// World to camera.
  const Eigen::Isometry3d& worldToCamera() const { return T_camera_world_; }

  /// Grid position of a point (camera frame, metres); NaN if it is behind the camera, or so far
  /// outside that margin() is not valid for it.
  Eigen::Vector2d place(const Eigen::Vector3d& point) const;
  /// Maximum distance, in grid steps, of a triangle's points from the box of its corners' grid
  /// positions, as distortion bends edges.
  /// \param plane_size size of the triangle's box in the plane z = 1
  double margin(double plane_size) const { return bend_ * plane_size * plane_size; }
  /// All grid positions whose points may lie in a box of the plane.
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
  Eigen::Vector2d low_, high_;         ///< bounds of the points in the plane
  /// Maximum squared distance from the axis in the plane, with a margin.
  double farthest_squared_ = 0.0;
  double bend_ = 0.0;
};

}  // namespace markerless_mocap
