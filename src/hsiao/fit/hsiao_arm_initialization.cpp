#include "hsiao/fit/hsiao_arm_initialization.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Minimum sine of the elbow's bend; below it, the plane of the arm is undetermined.
constexpr double kMinBend = 0.15;

Vector3d limitExcess(const Vector3d& angles, const HsiaoLimits& limits, int side) {
  Vector3d excess;
  for (int i = 0; i < 3; ++i) {
    const int k = 2 + 2 * i + side;  // theta_3, 5, 7 or theta_4, 6, 8
    excess[i] = std::max({0.0, limits.lower[k] - angles[i], angles[i] - limits.upper[k]});
  }
  return excess;
}

// Angles of R = Rx(a) Ry(b) Rz(c): the solution within the limits that is nearest to `near`.
Vector3d shoulderAngles(const Matrix3d& R, const HsiaoLimits& limits, int side,
                        const Vector3d& near) {
  const double b = std::asin(std::clamp(R(0, 2), -1.0, 1.0));
  const double a = std::atan2(-R(1, 2), R(2, 2)), c = std::atan2(-R(0, 1), R(0, 0));
  const auto wrap = [](double angle) { return std::remainder(angle, 2 * M_PI); };
  const std::array<Vector3d, 2> solutions = {
      Vector3d(a, b, c), Vector3d(wrap(a + M_PI), wrap(M_PI - b), wrap(c + M_PI))};
  const auto badness = [&](const Vector3d& t) {
    return 100.0 * limitExcess(t, limits, side).norm() + (t - near).norm();
  };
  return badness(solutions[0]) <= badness(solutions[1]) ? solutions[0] : solutions[1];
}

}  // namespace

PartLabel limbOfSide(const HsiaoSkeletonError& error, const HsiaoBodyModel& body_model,
                     const HsiaoFrames& frames, PartLabel first, int side) {
  const PartLabel second = PartLabel(int(first) + 1);
  if (!error.has(first) || !error.has(second)) return error.has(first) ? first : second;
  const Vector3d left = body_model.bones(first).front().inWorld(frames) -
                        body_model.bones(second).front().inWorld(frames);
  const Vector3d way = error.samples(first).front() - error.samples(second).front();
  return (left.dot(way) > 0) == (side == 0) ? first : second;
}

void initializeArm(const HsiaoSkeletonError& error, const HsiaoBodyModel& body_model,
                   const HsiaoLimits& limits, int side, HsiaoVector& v) {
  HsiaoFrames frames;
  body_model.frames(v.data(), frames);
  const PartLabel data = limbOfSide(error, body_model, frames, PartLabel::kArm1, side);
  const Matrix3d to_torso = frames.R[kTorsoSegment].transpose();
  const Vector3d shoulder = frames.p[kUpperArmSegment + side];
  const Vector3d &elbow = error.atNode(data, 1), &wrist = error.atNode(data, 2);
  const Vector3d upper = to_torso * (elbow - shoulder).normalized();
  const Vector3d fore = to_torso * (wrist - elbow).normalized();
  // Hsiao's elbows bend the forearm towards the x axis of the arm.
  const Matrix3d now = to_torso * frames.R[kUpperArmSegment + side];
  Vector3d x = fore - upper * upper.dot(fore);
  const double bend = std::atan2(x.norm(), upper.dot(fore));
  if (x.norm() < kMinBend) x = now.col(0) - upper * upper.dot(now.col(0));
  if (x.norm() < 1e-6) return;
  x.normalize();
  Matrix3d R;
  R.col(0) = x;
  R.col(1) = side == 0 ? upper : Vector3d(-upper);
  R.col(2) = x.cross(R.col(1));
  const Vector3d near(v[hsiaoTheta(3 + side)], v[hsiaoTheta(5 + side)], v[hsiaoTheta(7 + side)]);
  const Vector3d angles = shoulderAngles(R, limits, side, near);
  for (int i = 0; i < 3; ++i) v[hsiaoTheta(3 + 2 * i + side)] = angles[i];
  v[hsiaoTheta(9 + side)] = side == 0 ? -bend : bend;
}

}  // namespace markerless_mocap
