#pragma once

#include <Eigen/Core>

#include "contour/fit/pose_problem.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {

/// Pose first, then shape parameters.
constexpr int kPoseAndShapeUnknowns = kContourDof + kShapeParameterCount;

/// Normal equations of one sample: pose and shape parameters.
struct ShapeNormalEquations {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(kPoseAndShapeUnknowns, kPoseAndShapeUnknowns);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(kPoseAndShapeUnknowns);
};

/// Accumulates the equations of one sample: rays, containment, posture, known points.
/// \param outlier scale of the robust loss, metres
/// \param point_deviation of known points, metres
ShapeNormalEquations shapeNormalEquations(const CameraRig& rig, const ContourOptions& contour,
                                          const ContourBody& body, const ShapeSample& sample,
                                          const ContourPose& pose, double outlier,
                                          double point_deviation);

}  // namespace markerless_mocap
