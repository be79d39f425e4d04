#include "contour/measure/shape_equations.h"

#include <cmath>

#include "contour/fit/pose_priors.h"

namespace markerless_mocap {
namespace {

using PointRows = Eigen::Matrix<double, 3, kPoseAndShapeUnknowns>;

/// Derivatives of the position of an attached point with respect to pose and shape parameters.
void poseAndShapeJacobian(const ContourFrames& frames, const AttachedPoint& point,
                          const Eigen::Vector3d& at, PointRows& J) {
  poseJacobian(frames, point.segment, at, J.leftCols<kContourDof>());
  shapeJacobian(frames, point, J.rightCols<kShapeParameterCount>());
}

void addCones(const PoseProblem& problem, ShapeNormalEquations& equations) {
  Eigen::MatrixXd J(8, kPoseAndShapeUnknowns);
  PointRows rows;
  for (size_t c = 0; c < kContourCones; ++c) {
    const KinematicCone& cone = contourKinematicTree().cones[c];
    J.setZero();
    for (Eigen::Index end = 0; end < 2; ++end) {
      const ContourWorldCone& placed = problem.cones()[c];
      poseAndShapeJacobian(problem.frames(), cone.ends[end], end ? placed.b : placed.a, rows);
      J.middleRows<3>(4 * end) = rows;
      J(4 * end + 3, kContourDof + cone.radius[end]) = 1.0;
    }
    const Eigen::MatrixXd HJ = problem.sums()[c].hessian() * J;
    equations.H.noalias() += J.transpose() * HJ;
    equations.g.noalias() += J.transpose() * problem.sums()[c].gradient();
  }
}

void addPosture(const ContourPose& pose, ShapeNormalEquations& equations) {
  PoseNormalEquations posture;
  posture.clear();
  addPosturePriors(pose, posture);
  equations.H.topLeftCorner<kContourDof, kContourDof>() += posture.H;
  equations.g.head<kContourDof>() += posture.g;
}

void addKnownPoints(const PoseProblem& problem, const ContourBody& body, const ContourPose& pose,
                    const Eigen::Matrix3Xd& known, double deviation,
                    ShapeNormalEquations& equations) {
  const Eigen::Matrix3Xd points = body.points(pose);
  const double weight = 1.0 / (deviation * deviation);
  PointRows J;
  for (Eigen::Index i = 0; i < known.cols(); ++i) {
    const Eigen::Vector3d off = points.col(i) - known.col(i);
    if (!off.allFinite()) continue;
    poseAndShapeJacobian(problem.frames(), contourKinematicTree().points[size_t(i)], points.col(i),
                         J);
    equations.H.noalias() += weight * J.transpose() * J;
    equations.g.noalias() += weight * J.transpose() * off;
  }
}

}  // namespace

ShapeNormalEquations shapeNormalEquations(const CameraRig& rig, const ContourOptions& contour,
                                          const ContourBody& body, const ShapeSample& sample,
                                          const ContourPose& pose, double outlier,
                                          double point_deviation) {
  ShapeNormalEquations equations;
  PoseProblem problem(sample.seen, rig, contour);
  problem.evaluate(body, pose, outlier);
  addCones(problem, equations);
  addPosture(pose, equations);
  if (sample.known_points.cols() > 0)
    addKnownPoints(problem, body, pose, sample.known_points, point_deviation, equations);
  return equations;
}

}  // namespace markerless_mocap
