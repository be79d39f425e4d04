#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// A parallel view of a person from the side of a camera and a little from above.
class BodyView {
 public:
  /// \param middle on the floor below the person, world metres \param from the camera's position
  /// \param size of the picture, px; it shows 2.2 m of height
  BodyView(const Eigen::Vector3d& middle, const Eigen::Vector3d& from, cv::Size size);

  cv::Point at(const Eigen::Vector3d& point) const;
  double depth(const Eigen::Vector3d& point) const { return into_.dot(point); }
  const Eigen::Vector3d& into() const { return into_; }
  cv::Mat paper() const { return {size_, CV_8UC3, cv::Scalar::all(255)}; }

 private:
  Eigen::Vector3d middle_, right_, up_, into_;
  double scale_;
  cv::Size size_;
};

/// BGR colours of torso, head, arms and legs.
cv::Scalar partColor(int part);

/// Draws voxels as shaded cubes. \param colors one per voxel of the hull, BGR
void drawVoxels(const BodyView& view, const VisualHull& hull, const std::vector<cv::Scalar>& colors,
                cv::Mat* picture);
/// A line through points.
void drawCurve(const BodyView& view, const std::vector<Eigen::Vector3d>& points,
               const cv::Scalar& color, int width, cv::Mat* picture);
/// Joins pictures of one size, with a caption over each; an empty text: none.
cv::Mat joined(const std::vector<std::vector<cv::Mat>>& rows,
               const std::vector<std::string>& columns);

}  // namespace markerless_mocap
