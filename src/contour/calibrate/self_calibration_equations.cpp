#include "contour/calibrate/self_calibration_equations.h"

#include <algorithm>
#include <cmath>

#include "contour/fit/pose_priors.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using ConeJacobian = Eigen::Matrix<double, 8, kContourDof + 2>;

/// The rotation of a camera, in its own axes, that shifts its image.
Vector3d turnOfShift(const Camera& camera, double right, double down) {
  const Eigen::Matrix3d& K = camera.calibration().K;
  return {down / K(1, 1), -right / K(0, 0), 0.0};
}

/// The part of an observation that comes from one camera.
ContourObservation seenBy(size_t camera, const ContourObservation& seen) {
  ContourObservation out;
  out.views.resize(seen.views.size());
  out.views[camera] = seen.views[camera];
  for (const ContourRay& ray : seen.rays)
    if (size_t(ray.camera) == camera) out.rays.push_back(ray);
  return out;
}

/// Derivatives of the ends of a cone, relative to the camera, with respect to the pose and the
/// image shift of the camera (right, down). A rotation of the camera equals the opposite rotation
/// of the body about it.
ConeJacobian coneJacobian(const Camera& camera, const ContourFrames& frames, size_t cone,
                          const ContourWorldCone& placed) {
  const int segment = contourKinematicTree().cones[cone].ends[0].segment;
  const Eigen::Matrix3d& R = camera.calibration().T_world_camera.linear();
  ConeJacobian J = ConeJacobian::Zero();
  for (Eigen::Index end = 0; end < 2; ++end) {
    const Vector3d& at = end ? placed.b : placed.a;
    poseJacobian(frames, segment, at, J.block<3, kContourDof>(4 * end, 0));
    const Vector3d way = at - camera.position();
    J.block<3, 1>(4 * end, kContourDof) = way.cross(R * turnOfShift(camera, 1, 0));
    J.block<3, 1>(4 * end, kContourDof + 1) = way.cross(R * turnOfShift(camera, 0, 1));
  }
  return J;
}

/// Adds the equations of one camera.
void addCamera(size_t index, const Camera& camera, const PoseProblem& problem,
               OrientationNormalEquations& out) {
  const auto at = Eigen::Index(2 * index);
  for (size_t c = 0; c < kContourCones; ++c) {
    const ConeJacobian J = coneJacobian(camera, problem.frames(), c, problem.cones()[c]);
    const Eigen::Matrix<double, kContourDof + 2, kContourDof + 2> H =
        J.transpose() * problem.sums()[c].hessian() * J;
    const Eigen::Matrix<double, kContourDof + 2, 1> g =
        J.transpose() * problem.sums()[c].gradient();
    out.pose.H += H.topLeftCorner<kContourDof, kContourDof>();
    out.pose.g += g.head<kContourDof>();
    out.mixed.middleCols<2>(at) += H.topRightCorner<kContourDof, 2>();
    out.H.block<2, 2>(at, at) += H.bottomRightCorner<2, 2>();
    out.g.segment<2>(at) += g.tail<2>();
  }
  for (const RayMatch& match : problem.matches())
    out.explained[index] += std::abs(double(match.residual)) < kRayExplained;
}

}  // namespace

CameraRig rotatedRig(const CameraRig& rig, const ImageShifts& pixels) {
  CameraRig turned;
  for (size_t i = 0; i < rig.size(); ++i) {
    CameraCalibration camera = rig[i].calibration();
    const auto at = Eigen::Index(2 * i);
    const Vector3d turn = turnOfShift(rig[i], pixels[at], pixels[at + 1]);
    camera.T_world_camera.linear() = camera.T_world_camera.linear() * expSO3(turn);
    turned.emplace_back(camera);
  }
  return turned;
}

ContourObservation rotatedObservation(const ContourObservation& seen, const CameraRig& rig,
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

OrientationNormalEquations orientationNormalEquations(const CameraRig& rig,
                                                      const ContourOptions& contour,
                                                      const ContourBody& body,
                                                      const ContourObservation& seen,
                                                      const ContourPose& pose, double outlier) {
  const auto count = Eigen::Index(2 * rig.size());
  OrientationNormalEquations out{{},
                                 Eigen::MatrixXd::Zero(kContourDof, count),
                                 Eigen::MatrixXd::Zero(count, count),
                                 Eigen::VectorXd::Zero(count),
                                 std::vector<size_t>(rig.size())};
  out.pose.clear();
  addPosturePriors(pose, out.pose);
  for (size_t i = 0; i < rig.size(); ++i) {
    const ContourObservation part = seenBy(i, seen);
    ContourOptions options = contour;  // a ray has the same weight as among the rays of all cameras
    options.effective_rays *= double(part.rays.size()) / std::max(1.0, double(seen.rays.size()));
    PoseProblem problem(part, rig, options);
    problem.evaluate(body, pose, outlier);
    addCamera(i, rig[i], problem, out);
  }
  return out;
}

}  // namespace markerless_mocap
