#pragma once

#include <Eigen/Core>
#include <array>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Parameters of Fleischmann 2012, Table 5.1; x1 to x31 have the indices 0 to 30: pelvis roll,
/// pitch, yaw (rad; about x, y, z, yaw outermost) and position (m, world); then hips, knees,
/// clavicles, shoulders, elbows, spine and head (rad). Joints with three axes turn about x, y, z in
/// this order; the last axis belongs to the outer segment.
constexpr int kFleischmannParameterCount = 31;
using FleischmannVector = Eigen::Matrix<double, kFleischmannParameterCount, 1>;

/// Index of the first parameter of each joint. The right joints follow Fleischmann's order.
enum FleischmannJoint {
  kPelvisOrientation = 0,
  kPelvisPosition = 3,
  kLeftHip = 6,   ///< outward, forward, twist outward
  kLeftKnee = 9,  ///< bend
  kRightHip = 10,
  kRightKnee = 13,
  kLeftClavicle = 14,  ///< forward, up
  kLeftShoulder = 16,  ///< outward, forward, twist outward
  kLeftElbow = 19,     ///< bend
  kRightClavicle = 20,
  kRightShoulder = 22,
  kRightElbow = 25,
  kSpine = 26,    ///< forward, sideways
  kHeadTurn = 28  ///< sideways, down, twist
};
constexpr int kHeadTwist = kHeadTurn + 2;

/// Rigid segments. From the upper arms on, left ones are even and right ones odd.
enum FleischmannSegment {
  kPelvisSegment = 0,
  kChestSegment,
  kSkullSegment,
  kLeftClavicleSegment,
  kRightClavicleSegment,
  kLeftUpperArm,
  kRightUpperArm,
  kLeftLowerArm,
  kRightLowerArm,
  kLeftThigh,
  kRightThigh,
  kLeftCalf,
  kRightCalf,
  kFleischmannSegments
};

/// Frames of the segments in the world. The origin of a segment is its upper joint. In the zero
/// pose, standing with hanging arms, all axes are those of the pelvis (x forward, y left, z up).
struct FleischmannFrames {
  std::array<Eigen::Matrix3d, kFleischmannSegments> R;
  std::array<Eigen::Vector3d, kFleischmannSegments> p;
};

/// Minimum and maximum of each parameter.
struct FleischmannLimits {
  FleischmannVector lower, upper;
  /// Of people who stand, walk and reach; the pelvis is free.
  static FleischmannLimits walking();
  /// The ranges of motion of adults (American Academy of Orthopaedic Surgeons 1965), rounded up;
  /// the pelvis is free. Fleischmann 2012 gives no figures.
  static FleischmannLimits full();
};

/// Fleischmann's kinematic model with 31 parameters: all joints but wrists and ankles. Immutable.
class FleischmannBodyModel {
 public:
  /// Takes all lengths from the zero pose of the model. Throws std::invalid_argument if a required
  /// link is missing or is rotated in that pose.
  explicit FleischmannBodyModel(const BodyModel& model);

  /// \param v kFleischmannParameterCount values
  void frames(const double* v, FleischmannFrames& out) const;

  /// The parameters for given link poses. If several sets of parameters give the same pose, the one
  /// nearest to `near` is chosen. Exact for poses that the joints of the model can take.
  FleischmannVector parametersOf(const LinkPoses& T_world_link,
                                 const FleischmannVector& near) const;

  /// Index of the model's link that moves with a segment and has the same origin.
  int link(FleischmannSegment segment) const { return link_[segment]; }
  /// World positions of markerNames(), metres.
  std::vector<Eigen::Vector3d> markers(const FleischmannFrames& frames) const;

 private:
  struct Marker {
    FleischmannSegment segment;
    Eigen::Vector3d offset;
  };

  std::array<int, kFleischmannSegments> link_;
  std::array<Eigen::Vector3d, kFleischmannSegments> joint_;  // in the parent segment's frame
  std::vector<Marker> markers_;
};

}  // namespace markerless_mocap
