#pragma once

#include <Eigen/Core>

#include "contour/fit/pose_problem.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {

/// Pose first, then sizes.
constexpr int kPoseAndShapeUnknowns = kContourDof + kShapeParameterCount;

/// Normal equations of one instant's pose and the sizes.
struct ShapeNormalEquations {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(kPoseAndShapeUnknowns, kPoseAndShapeUnknowns);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(kPoseAndShapeUnknowns);
};

/// Sums up one instant: rays, containment, posture, known points.
ShapeNormalEquations shapeNormalEquations(const CameraRig& rig, const ContourOptions& contour,
                                          const ContourBody& body, const ShapeSample& instant,
                                          const ContourPose& pose, double outlier,
                                          double point_deviation);

}  // namespace markerless_mocap
