#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/products/curve_skeleton.h"

namespace markerless_mocap {

/// Part of the body that a node of the tree belongs to (Bakken & Hilton 2012, 3.3.4). kNone: a spur
/// that no part claims. What two legs share is the torso's, even where they are one down to the
/// feet.
enum class TreePart : uint8_t {
  kNone = 0,
  kTorso,
  kNeck,  ///< neck and head
  kLeftArm,
  kRightArm,
  kLeftLeg,
  kRightLeg
};
constexpr int kTreePartCount = 7;
/// "none", "torso", "neck", "left_arm", ...
const char* toString(TreePart part);

/// The ends of a body.
enum class Extremity : uint8_t { kHead = 0, kLeftHand, kRightHand, kLeftFoot, kRightFoot };
constexpr int kExtremityCount = 5;
/// "head", "left_hand", ...
const char* toString(Extremity extremity);

/// Joints read off a labelled tree by a body's proportions.
enum class TreeJoint : uint8_t {
  kNeck = 0,
  kLeftShoulder,
  kRightShoulder,
  kLeftElbow,
  kRightElbow,
  kLeftWrist,
  kRightWrist,
  kLeftHip,
  kRightHip,
  kLeftKnee,
  kRightKnee,
  kLeftAnkle,
  kRightAnkle
};
constexpr int kTreeJointCount = 13;
/// The marker's name of the same joint where there is one: "neck", "l_shoulder", "r_shoulder", ...
const char* toString(TreeJoint joint);

struct TreeNode {
  Eigen::Vector3d position =
      Eigen::Vector3d::Zero();  ///< smoothed along the skeleton, world metres
  int32_t parent = -1;          ///< index of a node; -1: the root
  TreePart part = TreePart::kNone;
};

/// Where a limb ends.
struct TreeExtremity {
  int32_t node = -1;                                       ///< the leaf of the tree; -1: not found
  Eigen::Vector3d skeleton_end = Eigen::Vector3d::Zero();  ///< of the leaf, world metres
  /// Knuckles of a hand, ball of a foot, middle of the head, world metres: the leaf lies beyond
  /// them, by an amount that was fitted on other people.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

enum class TreeStatus : uint8_t {
  kOk = 0,
  kNoSkeleton,      ///< the hull is empty or too small for a skeleton
  kNotAPerson,      ///< too large or too thick for one person, or several bodies
  kTooFewBranches,  ///< fewer than five ends or no node where they could meet
  kNoTorso,         ///< the limbs meet in one point
  kLowRank,         ///< no candidate for the origin ranks high enough
  kSidesUnknown,    ///< parts are found, forward is not
  kUncertain        ///< everything is found, but such frames are labelled wrong too often
};
/// "ok", "no_skeleton", ...
const char* toString(TreeStatus status);

/// What `pose_tree` makes of one hull. Below the status all is filled as far as it was found, so
/// that a rejected frame can be looked at; only a kOk one may be believed.
struct PoseTree {
  TreeStatus status = TreeStatus::kNoSkeleton;
  std::string reason;  ///< one sentence unless kOk
  double rank = 0.0;   ///< of the origin (Eq. 1), 0..1; 1: the ideal tree
  /// Estimated probability that all five labels and both sides are right; where ends are named by
  /// rank it is the rank.
  double validity = 0.0;
  CurveSkeleton skeleton;  ///< what the tree was made of, all its components
  /// One per voxel that the root reaches, parents before children; the root is the head's end, or
  /// the top-most voxel while the head is not known.
  std::vector<TreeNode> nodes;
  int32_t origin = -1;  ///< node where neck, arms and torso meet; -1: none
  std::array<TreeExtremity, kExtremityCount> extremities;              ///< by Extremity
  std::array<std::optional<Eigen::Vector3d>, kTreeJointCount> joints;  ///< by TreeJoint, metres
  Eigen::Vector3d forward = Eigen::Vector3d::Zero();  ///< unit vector; zero: not known
  Eigen::Vector3d left = Eigen::Vector3d::Zero();     ///< unit vector; zero: not known

  bool valid() const { return status == TreeStatus::kOk; }
  const TreeExtremity& extremity(Extremity extremity) const {
    return extremities[size_t(extremity)];
  }
  const std::optional<Eigen::Vector3d>& joint(TreeJoint joint) const {
    return joints[size_t(joint)];
  }
};

}  // namespace markerless_mocap
