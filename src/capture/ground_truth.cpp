#include "capture/ground_truth.h"

namespace markerless_mocap {
namespace {

/// A point at a fraction of the line from a bone's head to its tail.
struct PointOnBone {
  const char* name;
  Bone bone;
  double fraction;
};

/// Fraction of the hand, from the wrist to the tip of the middle finger.
constexpr double kKnuckles = 0.53;

constexpr PointOnBone kPoints[] = {
    {"pelvis", Bone::kHips, 0.0},
    {"thorax", Bone::kNeck, 0.0},
    {"head", Bone::kHead, 0.5},
    {"l_shoulder", Bone::kLeftUpperArm, 0.0},
    {"l_elbow", Bone::kLeftForearm, 0.0},
    {"l_wrist", Bone::kLeftHand, 0.0},
    {"r_shoulder", Bone::kRightUpperArm, 0.0},
    {"r_elbow", Bone::kRightForearm, 0.0},
    {"r_wrist", Bone::kRightHand, 0.0},
    {"l_hip", Bone::kLeftThigh, 0.0},
    {"l_knee", Bone::kLeftShank, 0.0},
    {"l_ankle", Bone::kLeftFoot, 0.0},
    {"r_hip", Bone::kRightThigh, 0.0},
    {"r_knee", Bone::kRightShank, 0.0},
    {"r_ankle", Bone::kRightFoot, 0.0},
    {"l_hand", Bone::kLeftHand, kKnuckles},
    {"l_hand_tip", Bone::kLeftHand, 1.0},
    {"l_foot", Bone::kLeftToes, 0.0},
    {"l_foot_tip", Bone::kLeftToes, 1.0},
    {"r_hand", Bone::kRightHand, kKnuckles},
    {"r_hand_tip", Bone::kRightHand, 1.0},
    {"r_foot", Bone::kRightToes, 0.0},
    {"r_foot_tip", Bone::kRightToes, 1.0},
    {"head_top", Bone::kHead, 1.0},
};

}  // namespace

const std::vector<std::string>& groundTruthNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const PointOnBone& point : kPoints) out.push_back(point.name);
    return out;
  }();
  return names;
}

std::vector<Eigen::Vector3d> groundTruthPoints(const HumanSkeleton& skeleton,
                                               const HumanPose& pose) {
  const PerBone<Eigen::Vector3d> heads = jointPositions(skeleton, pose);
  std::vector<Eigen::Vector3d> points;
  for (const PointOnBone& point : kPoints) {
    const Eigen::Vector3d& head = heads[size_t(point.bone)];
    const Eigen::Vector3d end = boneEnd(skeleton, pose, heads, point.bone);
    points.push_back(head + point.fraction * (end - head));
  }
  return points;
}

}  // namespace markerless_mocap
