#pragma once

#include <Eigen/Core>

#include "contour/fit/pose_problem.h"
#include "contour/size_estimator.h"

namespace markerless_mocap {

/// Pose first, then sizes.
constexpr int kJointUnknowns = kContourDof + kContourSizes;

/// Normal equations of one instant's pose and the sizes.
struct SizeEquations {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(kJointUnknowns, kJointUnknowns);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(kJointUnknowns);
};

/// Sums up one instant: rays, containment, posture, known points.
SizeEquations sizeEquations(const CameraRig& rig, const ContourOptions& contour,
                            const ContourBody& body, const SizeInstant& instant,
                            const ContourPose& pose, double outlier, double point_deviation);

}  // namespace markerless_mocap
