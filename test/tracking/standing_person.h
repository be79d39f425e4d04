#pragma once

#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Joint centres of somebody who stands at the origin, m: head, neck, hips, then shoulder, elbow,
/// wrist, hip, knee, ankle of both sides.
inline std::vector<Eigen::Vector3d> standingJoints() {
  std::vector<Eigen::Vector3d> joints{{0, 0, 1.6}, {0, 0, 1.45}, {0, 0, 0.95}};
  for (const double side : {-1.0, 1.0}) {
    joints.insert(joints.end(),
                  {{side * 0.18, 0, 1.4}, {side * 0.3, 0, 1.15}, {side * 0.35, 0, 0.9}});
    joints.insert(joints.end(),
                  {{side * 0.1, 0, 0.9}, {side * 0.12, 0, 0.5}, {side * 0.13, 0, 0.1}});
  }
  return joints;
}

/// What a camera at this place sees of them; it looks along the world's y.
inline Camera cameraAt(const Eigen::Vector3d& place, double focal_length) {
  CameraCalibration calibration;
  calibration.name = "a";
  calibration.width = 320;
  calibration.height = 240;
  calibration.K << focal_length, 0, 159.5, 0, focal_length, 119.5, 0, 0, 1;
  calibration.T_world_camera.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  calibration.T_world_camera.translation() = place;
  return Camera(calibration);
}

/// Their silhouette.
inline cv::Mat silhouetteOf(const Camera& camera, const std::vector<Eigen::Vector3d>& joints) {
  cv::Mat mask(camera.height(), camera.width(), CV_8UC1, cv::Scalar(0));
  const auto draw = [&](size_t from, size_t to, double radius) {
    const auto a = camera.project(joints[from]), b = camera.project(joints[to]);
    const double depth = (joints[from] - camera.position()).y();
    const int width = int(2 * radius * camera.calibration().K(0, 0) / depth) + 1;
    cv::line(mask, {int(a->x()), int(a->y())}, {int(b->x()), int(b->y())}, cv::Scalar(255), width);
  };
  draw(0, 0, 0.11);
  draw(0, 1, 0.05);
  draw(1, 2, 0.15);
  for (const size_t side : {size_t(3), size_t(9)}) {
    draw(side, side + 1, 0.05);
    draw(side + 1, side + 2, 0.05);
    draw(side + 3, side + 4, 0.07);
    draw(side + 4, side + 5, 0.06);
  }
  return mask;
}

}  // namespace markerless_mocap
