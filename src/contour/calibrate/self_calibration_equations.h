#pragma once

#include <Eigen/Core>

#include "contour/fit/pose_problem.h"

namespace markerless_mocap {

/// Shift of each camera's image in its middle: right and down of the first camera, of the second...
/// pixels.
using PointingPixels = Eigen::VectorXd;

/// The rig with each camera turned so that images shift so far.
CameraRig turnedRig(const CameraRig& rig, const PointingPixels& pixels);

/// What the same masks are to the turned rig.
ContourObservation turnedObservation(const ContourObservation& seen, const CameraRig& rig,
                                     const CameraRig& turned);

/// Normal equations of one instant's pose and the cameras' pointing.
struct PointingEquations {
  PoseEquations pose;
  Eigen::MatrixXd mixed;          ///< pose by pointing
  Eigen::MatrixXd H;              ///< of the pointing
  Eigen::VectorXd g;              ///< gradient of half the weighted sum of squares
  std::vector<size_t> explained;  ///< rays by camera nearer than kRayExplained
};

/// Sums up one instant: rays, containment, posture.
/// \param rig, seen as turned so far \param outlier distance from which on a ray is mostly ignored,
/// metres
PointingEquations pointingEquations(const CameraRig& rig, const ContourOptions& contour,
                                    const ContourBody& body, const ContourObservation& seen,
                                    const ContourPose& pose, double outlier);

}  // namespace markerless_mocap
