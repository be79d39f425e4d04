#pragma once

#include <Eigen/Core>
#include <optional>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// \param calibration with a D of an allowed length
LensNumbers lensNumbersOf(const CameraCalibration& calibration);

/// The distorted image-plane point of a point in the camera's frame; empty where the lens sees
/// nothing.
std::optional<Eigen::Vector2d> distortedPoint(const LensNumbers& lens,
                                              const Eigen::Vector3d& in_camera);

/// The direction, in the camera's frame and of any length, of a distorted image-plane point. Beyond
/// the lens's reach it is at the reach.
Eigen::Vector3d undistortedDirection(const LensNumbers& lens, const Eigen::Vector2d& distorted);

/// Whether a distorted image-plane point has a direction, and the lens moves it as lenses do.
bool isSeenByLens(const LensNumbers& lens, const Eigen::Vector2d& distorted, double tolerance);

/// How much larger a fisheye shows what is small and beside the axis than what is at the same
/// distance on the axis: the root of the ratio of the areas.
double fisheyeScale(const LensNumbers& lens, const Eigen::Vector3d& in_camera);

}  // namespace markerless_mocap
