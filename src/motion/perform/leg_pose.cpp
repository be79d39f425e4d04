#include "motion/perform/leg_pose.h"

#include <algorithm>
#include <cmath>

#include "motion/skeleton/two_bone_ik.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

constexpr double kStretch = 0.995;  // fraction of a leg's length that a standing leg uses
constexpr double kMaxBend = 2.6;    // radians
constexpr double kKneesOut = 0.1;   // outward component of the knee direction

Eigen::Vector3d hipJoint(const HumanSkeleton& skeleton, const HumanPose& pose, Bone thigh) {
  return pose.hips + pose[Bone::kHips] * (skeleton.headOf(thigh) - skeleton.headOf(Bone::kHips));
}

/// Direction of the knee if the leg hung straight down: between the directions of foot and pelvis.
Eigen::Vector3d kneesAhead(const HumanPose& pose, const FootPose& foot, bool left) {
  const Eigen::Vector3d of_foot(std::cos(foot.heading), std::sin(foot.heading), 0.0);
  const Eigen::Vector3d of_pelvis = pose[Bone::kHips] * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d outward = pose[Bone::kHips] * Eigen::Vector3d(0, left ? 1.0 : -1.0, 0);
  Eigen::Vector3d ahead = 0.6 * of_foot + 0.4 * of_pelvis + kKneesOut * outward;
  ahead.z() = 0.0;
  return ahead.normalized();
}

void poseLeg(bool left, const FootPose& foot, const HumanSkeleton& skeleton, HumanPose& pose) {
  const Bone thigh = left ? Bone::kLeftThigh : Bone::kRightThigh;
  const Bone shank = left ? Bone::kLeftShank : Bone::kRightShank;
  const Bone foot_bone = left ? Bone::kLeftFoot : Bone::kRightFoot;
  const Bone toes = left ? Bone::kLeftToes : Bone::kRightToes;
  const Eigen::Vector3d hip = hipJoint(skeleton, pose, thigh);
  const Eigen::Vector3d ankle = softIkTarget(hip, foot.ankle, skeleton.legLength());
  // Rotated with the leg, so that the knee of a raised leg points up.
  const Eigen::Vector3d pole =
      shortestRotation(-Eigen::Vector3d::UnitZ(), ankle - hip) * kneesAhead(pose, foot, left);
  const TwoBoneIkResult bend = solveTwoBoneIk(hip, ankle, skeleton.lengthOf(thigh),
                                              skeleton.lengthOf(shank), pole, kMaxBend);
  const Eigen::Vector3d hinge = pole.cross(bend.end - hip);  // to the left at rest
  const auto turned = [&](Bone bone, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    pose[bone] = turnWithHinge(skeleton.tailOf(bone) - skeleton.headOf(bone),
                               Eigen::Vector3d::UnitY(), to - from, hinge);
  };
  turned(thigh, hip, bend.middle);
  turned(shank, bend.middle, bend.end);
  pose[foot_bone] = foot.foot;
  pose[toes] = foot.toes;
}

}  // namespace

void poseLegs(const GaitState& now, const HumanSkeleton& skeleton, HumanPose& pose) {
  poseLeg(true, now.left, skeleton, pose);
  poseLeg(false, now.right, skeleton, pose);
}

double maxHipHeight(const GaitState& now, const HumanSkeleton& skeleton, const HumanPose& pose,
                    double otherwise) {
  const double reach = kStretch * skeleton.legLength();
  double maximum = otherwise;
  for (const bool left : {true, false}) {
    const FootPose& foot = left ? now.left : now.right;
    if (!foot.within_reach) continue;
    const Eigen::Vector3d hip =
        hipJoint(skeleton, pose, left ? Bone::kLeftThigh : Bone::kRightThigh);
    const double away = (hip - foot.ankle).head<2>().norm();
    const double above = std::sqrt(std::max(0.0, reach * reach - away * away));
    maximum = std::min(maximum, foot.ankle.z() + above - (hip.z() - pose.hips.z()));
  }
  return maximum;
}

}  // namespace markerless_mocap
