#include "contour/self_calibration_equations.h"

#include <algorithm>
#include <cmath>

#include "contour/pose_priors.h"
#include "contour/robust.h"

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using PointJacobian = Eigen::Matrix<double, 3, kContourDof>;

/// The turn of a camera in its own axes by which its image shifts.
Vector3d turnOfShift(const Camera& camera, double right, double down) {
  const Matrix3d& K = camera.calibration().K;
  return {down / K(1, 1), -right / K(0, 0), 0.0};
}

/// What moves the axes of the cones.
struct AxisJacobians {
  std::array<std::array<PointJacobian, 2>, kContourCones> end;

  AxisJacobians(const ContourFrames& frames, const PlacedCones& cones) {
    for (int c = 0; c < kContourCones; ++c) {
      const TreeCone& cone = contourTree().cones[size_t(c)];
      const PlacedCone& placed = cones[size_t(c)];
      poseJacobian(frames, cone.ends[0].segment, placed.a, end[size_t(c)][0]);
      poseJacobian(frames, cone.ends[1].segment, placed.b, end[size_t(c)][1]);
    }
  }
};

/// Derivatives of a residual by its camera's shift to the right and down. That the camera turns is
/// as if the body turned about it the other way.
Eigen::Vector2d slopeByShift(const Camera& camera, const Vector3d& axis_point,
                             const Vector3d& slope) {
  const Vector3d by_turn = slope.cross(axis_point - camera.position());
  const Matrix3d& R = camera.calibration().T_world_camera.linear();
  return {by_turn.dot(R * turnOfShift(camera, 1, 0)), by_turn.dot(R * turnOfShift(camera, 0, 1))};
}

}  // namespace

CameraRig turnedRig(const CameraRig& rig, const PointingPixels& pixels) {
  CameraRig turned;
  for (size_t i = 0; i < rig.size(); ++i) {
    CameraCalibration camera = rig[i].calibration();
    const auto at = Eigen::Index(2 * i);
    const Vector3d turn = turnOfShift(rig[i], pixels[at], pixels[at + 1]);
    camera.T_world_camera.linear() = camera.T_world_camera.linear() * rotationOf(turn);
    turned.emplace_back(camera);
  }
  return turned;
}

ContourObservation turnedObservation(const ContourObservation& seen, const CameraRig& rig,
                                     const CameraRig& turned) {
  std::vector<Eigen::Matrix3f> R;
  for (size_t i = 0; i < rig.size(); ++i)
    R.push_back((turned[i].calibration().T_world_camera.linear() *
                 rig[i].calibration().T_world_camera.linear().transpose())
                    .cast<float>());
  ContourObservation out = seen;
  for (ContourRay& ray : out.rays) {
    ray.normal = R[size_t(ray.camera)] * ray.normal;
    ray.side = R[size_t(ray.camera)] * ray.side;
    const Eigen::Vector3f eye = turned[size_t(ray.camera)].position().cast<float>();
    ray.normal_of_ray = ray.normal.dot(eye);
    ray.side_of_ray = ray.side.dot(eye);
  }
  return out;
}

PointingEquations pointingEquations(const CameraRig& rig, const ContourOptions& contour,
                                    const ContourBody& body, const ContourObservation& seen,
                                    const ContourPose& pose, double outlier) {
  PoseProblem problem(seen, rig, contour);
  problem.evaluate(body, pose, outlier);
  const auto count = Eigen::Index(2 * rig.size());
  PointingEquations out{{},
                        Eigen::MatrixXd::Zero(kContourDof, count),
                        Eigen::MatrixXd::Zero(count, count),
                        Eigen::VectorXd::Zero(count),
                        std::vector<size_t>(rig.size())};
  out.pose.clear();
  addToPose(problem.sums(), problem.frames(), problem.cones(), out.pose);
  addPosturePriors(pose, out.pose);
  const AxisJacobians jacobians(problem.frames(), problem.cones());
  const double one = contour.contour_weight / (contour.sigma * contour.sigma) /
                     std::max(1.0, double(seen.rays.size()));
  for (size_t i = 0; i < seen.rays.size(); ++i) {
    const RayMatch& match = problem.matches()[i];
    const ContourRay& ray = seen.rays[i];
    const auto cone = size_t(match.cone), camera = size_t(ray.camera);
    const Vector3d slope =
        (match.along_normal * ray.normal + match.along_side * ray.side).cast<double>();
    const double s = match.s, weight = one * robustWeight(match.residual, outlier);
    const PlacedCone& placed = problem.cones()[cone];
    const Eigen::Vector2d by_shift =
        slopeByShift(rig[camera], placed.a + s * (placed.b - placed.a), slope);
    const PoseStep by_pose =
        ((1 - s) * jacobians.end[cone][0] + s * jacobians.end[cone][1]).transpose() * slope;
    const auto at = Eigen::Index(2 * camera);
    out.mixed.middleCols<2>(at) += weight * by_pose * by_shift.transpose();
    out.H.block<2, 2>(at, at) += weight * by_shift * by_shift.transpose();
    out.g.segment<2>(at) += weight * match.residual * by_shift;
    out.explained[camera] += std::abs(double(match.residual)) < kRayExplained;
  }
  return out;
}

}  // namespace markerless_mocap
