#pragma once

#include <Eigen/Core>

#include "contour/fit/pose_problem.h"

namespace markerless_mocap {

/// Shift of the centre of each camera's image, pixels: right and down of the first camera, then of
/// the second, and so on.
using ImageShifts = Eigen::VectorXd;

/// The rig with each camera rotated so that its image shifts by these pixels.
CameraRig rotatedRig(const CameraRig& rig, const ImageShifts& pixels);

/// The observation of the same masks with the rotated rig.
ContourObservation rotatedObservation(const ContourObservation& seen, const CameraRig& rig,
                                      const CameraRig& turned);

/// Normal equations of one sample: the pose and the camera orientations.
struct OrientationNormalEquations {
  PoseNormalEquations pose;
  Eigen::MatrixXd mixed;          ///< pose x orientations
  Eigen::MatrixXd H;              ///< orientations x orientations
  Eigen::VectorXd g;              ///< gradient of half the weighted sum of squares
  std::vector<size_t> explained;  ///< per camera: rays nearer to the body than kRayExplained
};

/// Accumulates the equations of one sample: rays, containment and posture.
/// \param rig, seen with the rotations so far
/// \param outlier scale of the robust loss, metres
OrientationNormalEquations orientationNormalEquations(const CameraRig& rig,
                                                      const ContourOptions& contour,
                                                      const ContourBody& body,
                                                      const ContourObservation& seen,
                                                      const ContourPose& pose, double outlier);

}  // namespace markerless_mocap
