#pragma once

#include <Eigen/Core>

#include "contour/fit/pose_problem.h"

namespace markerless_mocap {

/// Shift of each camera's image in its middle: right and down of the first camera, of the second...
/// pixels.
using ImageShifts = Eigen::VectorXd;

/// The rig with each camera turned so that images shift so far.
CameraRig rotatedRig(const CameraRig& rig, const ImageShifts& pixels);

/// What the same masks are to the turned rig.
ContourObservation rotatedObservation(const ContourObservation& seen, const CameraRig& rig,
                                      const CameraRig& turned);

/// Normal equations of one instant's pose and the cameras' pointing.
struct OrientationNormalEquations {
  PoseNormalEquations pose;
  Eigen::MatrixXd mixed;          ///< pose by pointing
  Eigen::MatrixXd H;              ///< of the pointing
  Eigen::VectorXd g;              ///< gradient of half the weighted sum of squares
  std::vector<size_t> explained;  ///< rays by camera nearer than kRayExplained
};

/// Sums up one instant: rays, containment, posture.
/// \param rig, seen as turned so far \param outlier distance from which on a ray is mostly ignored,
/// metres
OrientationNormalEquations orientationNormalEquations(const CameraRig& rig,
                                                      const ContourOptions& contour,
                                                      const ContourBody& body,
                                                      const ContourObservation& seen,
                                                      const ContourPose& pose, double outlier);

}  // namespace markerless_mocap
