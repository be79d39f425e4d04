#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/core/mat.hpp>
#include <random>
#include <vector>

#include "contour/model/contour_body.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

// Masks of the very body that is fitted, for tests of algebra and of what follows from a fit:
// derivatives, limits, who is found, lost or measured when. They say nothing about the accuracy on
// a person; mesh_person.h and test/accuracy do.

/// Cameras around the origin at 4 m, looking at a standing person's middle.
inline CameraRig drawnRig(int cameras, double distortion_k1 = 0.0) {
  CameraRig rig;
  for (int i = 0; i < cameras; ++i) {
    CameraCalibration c;
    c.name = "cam" + std::to_string(i);
    c.width = 320;
    c.height = 240;
    c.K << 300, 0, 159.5, 0, 300, 119.5, 0, 0, 1;
    c.D = {distortion_k1, 0, 0, 0};
    const double turn = 2 * M_PI * i / cameras;
    const Eigen::Vector3d at(4 * std::cos(turn), 4 * std::sin(turn), i % 2 ? 1.2 : 2.2);
    const Eigen::Vector3d z = (Eigen::Vector3d(0, 0, 0.95) - at).normalized();
    const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
    c.T_world_camera.linear() << x, z.cross(x), z;
    c.T_world_camera.translation() = at;
    rig.emplace_back(c);
  }
  return rig;
}

/// Whether a ray comes as near to the cone as its radius: tried at many of its balls.
inline bool meets(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray,
                  const ContourWorldCone& cone) {
  for (int i = 0; i <= 30; ++i) {
    const double s = i / 30.0;
    const Eigen::Vector3d way = cone.a + s * (cone.b - cone.a) - eye;
    const double radius = cone.radius_a + s * (cone.radius_b - cone.radius_a);
    if ((way - ray * ray.dot(way)).squaredNorm() < radius * radius) return true;
  }
  return false;
}

/// The body's mask, pixel by pixel: no code of the fitter's is used.
inline cv::Mat drawnMask(const Camera& camera, const ContourWorldCones& cones) {
  cv::Mat mask = cv::Mat::zeros(camera.height(), camera.width(), CV_8UC1);
  for (const ContourWorldCone& cone : cones) {
    const Eigen::Vector2d a = *camera.project(cone.a), b = *camera.project(cone.b);
    const double reach = 1.5 * 300 / 3 * std::max(cone.radius_a, cone.radius_b) + 2;
    const int x0 = std::max(0, int(std::min(a.x(), b.x()) - reach));
    const int x1 = std::min(mask.cols - 1, int(std::max(a.x(), b.x()) + reach));
    const int y0 = std::max(0, int(std::min(a.y(), b.y()) - reach));
    const int y1 = std::min(mask.rows - 1, int(std::max(a.y(), b.y()) + reach));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        if (!mask.at<uchar>(y, x) &&
            meets(camera.position(), camera.rayDirection(Eigen::Vector2d(x, y)), cone))
          mask.at<uchar>(y, x) = 255;
  }
  return mask;
}

inline std::vector<cv::Mat> drawnMasks(const CameraRig& rig, const ContourBody& body,
                                       const ContourPose& pose) {
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(pose, frames);
  body.place(frames, cones);
  std::vector<cv::Mat> masks;
  for (const Camera& camera : rig) masks.push_back(drawnMask(camera, cones));
  return masks;
}

/// Both arms away from the body, one elbow bent, in stride.
inline ContourPose stride() {
  ContourPose pose;
  pose.position << 0.05, -0.1, 0.92;
  pose.rotations[SphericalJoint::kRoot] = expSO3({0, 0, 0.4});
  pose.rotations[SphericalJoint::kNeck] = expSO3({0.1, 0.1, 0.2});
  pose.rotations[SphericalJoint::kLeftShoulder] = expSO3({0.8, -0.4, 0});
  pose.rotations[SphericalJoint::kRightShoulder] = expSO3({-1.0, 0.3, 0.2});
  pose.rotations[SphericalJoint::kLeftHip] = expSO3({0.15, -0.5, 0.1});
  pose.rotations[SphericalJoint::kRightHip] = expSO3({-0.15, 0.3, 0});
  pose.angles[RevoluteJoint::kSpinePitch] = 0.15;
  pose.angles[RevoluteJoint::kSpineTwist] = 0.1;
  pose.angles[RevoluteJoint::kLeftElbow] = 0.9;
  pose.angles[RevoluteJoint::kRightElbow] = 0.4;
  pose.angles[RevoluteJoint::kLeftKnee] = -0.5;
  pose.angles[RevoluteJoint::kRightKnee] = -0.3;
  return pose;
}

/// The pose off by normally distributed amounts. \param turn rad \param move metres
inline ContourPose disturbed(const ContourPose& pose, double turn, double move, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  PoseIncrement step;
  for (int i = 0; i < kContourDof; ++i) step[i] = normal(random) * (i < 3 ? move : turn);
  return boxPlus(pose, step);
}

/// Mean distance of the fifteen joints, metres.
inline double jointDistance(const ContourBody& one, const ContourPose& pose,
                            const ContourBody& other, const ContourPose& other_pose) {
  return (one.points(pose) - other.points(other_pose)).leftCols<15>().colwise().norm().mean();
}

}  // namespace markerless_mocap
