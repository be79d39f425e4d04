#pragma once

#include <Eigen/Core>
#include <array>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// F's parameters (Fleischmann 2012, Table 5.1), x1 to x31 at positions 0 to 30: pelvis roll,
/// pitch, yaw (rad; about x, y, z, the yaw outermost) and position (m, world); hips, knees,
/// clavicles, shoulders, elbows, spine, head (rad). Three-axis joints turn about x, y, z in this
/// order, so the last one turns about the outer segment.
constexpr int kFleischmannParameterCount = 31;
using FleischmannVector = Eigen::Matrix<double, kFleischmannParameterCount, 1>;

/// Position of the first parameter of each joint. Right ones follow F's order.
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

/// What moves rigidly. Left is even, right odd from the upper arms on.
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

/// Frames of the segments in the world. A segment's origin is its upper joint; in the zero pose,
/// standing with hanging arms, all axes are the pelvis's (x forward, y left, z up).
struct FleischmannFrames {
  std::array<Eigen::Matrix3d, kFleischmannSegments> R;
  std::array<Eigen::Vector3d, kFleischmannSegments> p;
};

/// Lowest and highest value of each parameter.
struct FleischmannLimits {
  FleischmannVector lower, upper;
  /// Anatomical limits of standing, walking and reaching people; the pelvis is free.
  static FleischmannLimits anatomical();
};

/// The 31-parameter profile of the body model: all joints but wrists and ankles. Immutable.
class FleischmannBodyModel {
 public:
  /// Measures all lengths in the model's zero pose. Throws std::invalid_argument if a link that is
  /// needed is missing or rotated in that pose.
  explicit FleischmannBodyModel(const BodyModel& model);

  /// \param v kFleischmannParameterCount values
  void frames(const double* v, FleischmannFrames& out) const;

  /// The parameters of a body whose links stand like this; of the several that give the same pose,
  /// those nearest to `near`. Exact for poses that the model's joints can take.
  FleischmannVector parametersOf(const LinkPoses& T_world_link,
                                 const FleischmannVector& near) const;

  /// The model's link that moves with a segment and sits at its origin.
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
