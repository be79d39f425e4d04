#pragma once

#include <Eigen/Core>
#include <array>

namespace markerless_mocap {

/// Joints that turn about any axis, held as rotation matrices: no angle of theirs is singular. The
/// root's rotation takes the pelvis frame (x out of the belly, y to the left, z to the head) to the
/// world, the others take the outer segment's frame to the inner one's. Identity stands upright
/// with arms hanging.
struct SphericalJoint {
  enum Id { kRoot, kNeck, kLeftShoulder, kRightShoulder, kLeftHip, kRightHip, kCount };
};

/// Joints of known axes, radians; signs as in urdf/human.urdf.in, zero as there. The spine's twist
/// is positive to the left, the ankles' angle lifts the toes.
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

/// Degrees of freedom: 3 of the root's position, 3 of each ball, 1 of each angle, in this order.
constexpr int kContourDof = 3 + 3 * SphericalJoint::kCount + RevoluteJoint::kCount;
constexpr int sphericalDof(int ball) {
  return 3 + 3 * ball;
}
constexpr int revoluteDof(int angle) {
  return 3 + 3 * SphericalJoint::kCount + angle;
}

/// A change of pose: metres, then radians. A ball's three turn it about its own (outer) axes:
/// R <- R exp(step).
using PoseIncrement = Eigen::Matrix<double, kContourDof, 1>;

/// A body at one instant, whatever its sizes.
struct ContourPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the hips' middle in the world, metres
  std::array<Eigen::Matrix3d, SphericalJoint::kCount> rotations;
  std::array<double, RevoluteJoint::kCount> angles{};

  ContourPose() { rotations.fill(Eigen::Matrix3d::Identity()); }
  bool isFinite() const;
};

/// The pose after a step; rotations stay orthonormal.
ContourPose boxPlus(const ContourPose& pose, const PoseIncrement& step);
/// The step that leads from one pose to the other: boxPlus(from, boxMinus(to, from)) is `to`.
PoseIncrement boxMinus(const ContourPose& to, const ContourPose& from);

/// Rotation by a vector's length about its direction (Rodrigues).
Eigen::Matrix3d expSO3(const Eigen::Vector3d& turn);
/// The vector whose expSO3() is R, not longer than pi.
Eigen::Vector3d logSO3(const Eigen::Matrix3d& R);

}  // namespace markerless_mocap
