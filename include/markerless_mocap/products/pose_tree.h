#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/products/curve_skeleton.h"

namespace markerless_mocap {

/// Part of the body to which a node of the tree belongs (Bakken & Hilton 2012, 3.3.4). kNone: a
/// spur that belongs to no part. Nodes that lie on the paths to both feet belong to the torso, even
/// if the legs are merged down to the feet.
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

/// The extremities of a body.
enum class Extremity : uint8_t { kHead = 0, kLeftHand, kRightHand, kLeftFoot, kRightFoot };
constexpr int kExtremityCount = 5;
/// "head", "left_hand", ...
const char* toString(Extremity extremity);

/// Joints that are located on a labelled tree by body proportions.
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
/// "neck", "l_shoulder", "r_shoulder", ...: the name in markerNames() if the joint is there.
const char* toString(TreeJoint joint);

struct TreeNode {
  /// Smoothed along the skeleton, world metres.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  int32_t parent = -1;  ///< index of a node; -1: the root
  TreePart part = TreePart::kNone;
};

/// The extremity of a limb.
struct TreeExtremity {
  int32_t node = -1;                                       ///< leaf of the tree; -1: not found
  Eigen::Vector3d skeleton_end = Eigen::Vector3d::Zero();  ///< position of the leaf, world metres
  /// Estimated position of a hand's knuckles, a foot's ball or the head's centre, world metres. The
  /// offset from the leaf was learned from recordings of other people.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

enum class TreeStatus : uint8_t {
  kOk = 0,
  kNoSkeleton,      ///< the hull is empty or too small for a skeleton
  kNotAPerson,      ///< too large or too thick for one person, or several bodies
  kTooFewBranches,  ///< fewer than five extremities, or no node where they could meet
  kNoTorso,         ///< the limbs meet in one point
  kLowRank,         ///< no candidate for the origin ranks high enough
  kSidesUnknown,    ///< the parts are found, the forward direction is not
  kUncertain        ///< everything is found, but the estimated validity is too low
};
/// "ok", "no_skeleton", ...
const char* toString(TreeStatus status);

/// Result of `pose_tree` for one hull. The fields are filled as far as they were found, so that a
/// rejected frame can be inspected. Labels are reliable only if the status is kOk.
struct PoseTree {
  TreeStatus status = TreeStatus::kNoSkeleton;
  std::string reason;  ///< message for the user unless kOk
  double rank = 0.0;   ///< rank of the origin (Eq. 1), 0 to 1; 1: the ideal tree
  /// Estimated probability that all five labels and both sides are correct. It equals the rank if
  /// extremities are labelled by rank.
  double validity = 0.0;
  CurveSkeleton skeleton;  ///< the skeleton from which the tree was built, with all its components
  /// One node per voxel that is connected to the root; parents precede children. The root is the
  /// head's extremity, or the top-most voxel if the head is not found.
  std::vector<TreeNode> nodes;
  int32_t origin = -1;  ///< node where neck, arms and torso meet; -1: not found
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
