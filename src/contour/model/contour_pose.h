#pragma once

#include <Eigen/Core>
#include <array>

namespace markerless_mocap {

/// Joints with three degrees of freedom, stored as rotation matrices to avoid singularities. The
/// root's rotation maps the pelvis frame (x forward, y to the left, z up) to the world; the others
/// map the frame of the outer segment to that of the inner one. Identity is the upright pose with
/// hanging arms.
struct SphericalJoint {
  enum Id { kRoot, kNeck, kLeftShoulder, kRightShoulder, kLeftHip, kRightHip, kCount };
};

/// Joints with known axes, radians; signs and zero as in urdf/human.urdf.in. A positive spine twist
/// turns to the left, a positive ankle angle lifts the toes.
struct RevoluteJoint {
  enum Id {
    kSpinePitch,
    kSpineRoll,
    kSpineTwist,
    kLeftClavicleYaw,
    kLeftClavicleRoll,
    kRightClavicleYaw,
    kRightClavicleRoll,
    kLeftElbow,
    kRightElbow,
    kLeftKnee,
    kRightKnee,
    kLeftAnkle,
    kRightAnkle,
    kCount
  };
};

/// Degrees of freedom: 3 of the root's position, 3 of each spherical joint, 1 of each revolute
/// joint, in this order.
constexpr int kContourDof = 3 + 3 * SphericalJoint::kCount + RevoluteJoint::kCount;
constexpr int sphericalDof(int joint) {
  return 3 + 3 * joint;
}
constexpr int revoluteDof(int joint) {
  return 3 + 3 * SphericalJoint::kCount + joint;
}

/// A change of pose: metres, then radians. A spherical joint turns about the axes of its outer
/// frame: R <- R exp(step).
using PoseIncrement = Eigen::Matrix<double, kContourDof, 1>;

/// A pose of the contour body, independent of its shape.
struct ContourPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< midpoint of the hips in the world,
                                                       ///< metres
  std::array<Eigen::Matrix3d, SphericalJoint::kCount> rotations;
  std::array<double, RevoluteJoint::kCount> angles{};

  ContourPose() { rotations.fill(Eigen::Matrix3d::Identity()); }
  bool isFinite() const;
};

/// The pose after an increment; rotations stay orthonormal.
ContourPose boxPlus(const ContourPose& pose, const PoseIncrement& step);
/// The increment between two poses: boxPlus(from, boxMinus(to, from)) is `to`.
PoseIncrement boxMinus(const ContourPose& to, const ContourPose& from);

/// Rotation about the direction of a vector by its length, radians (Rodrigues).
Eigen::Matrix3d expSO3(const Eigen::Vector3d& turn);
/// The rotation vector of R, not longer than pi.
Eigen::Vector3d logSO3(const Eigen::Matrix3d& R);

}  // namespace markerless_mocap
