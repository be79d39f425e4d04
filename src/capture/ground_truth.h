#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "motion/human_pose.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Names of the true points: the fifteen of markerNames(), then l_hand (knuckles), l_hand_tip,
/// l_foot (ball of the foot), l_foot_tip, the same of the right, head_top.
const std::vector<std::string>& groundTruthNames();

/// The true points of a person in the world, metres, in the order of groundTruthNames().
std::vector<Eigen::Vector3d> groundTruthPoints(const HumanSkeleton& skeleton,
                                               const HumanPose& pose);

}  // namespace markerless_mocap
