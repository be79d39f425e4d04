#pragma once

#include "motion/gait/gait_states.h"

namespace markerless_mocap {

/// Poses thighs, shanks, feet and toes so that the feet reach their given poses. Hips must be posed
/// before.
void poseLegs(const GaitState& now, const HumanSkeleton& skeleton, HumanPose& pose);

/// Maximum height of the hips, metres, at which the knees of standing legs are still slightly bent;
/// `otherwise` if no foot stands. The rotation and the horizontal position of the hips must be set
/// before.
double maxHipHeight(const GaitState& now, const HumanSkeleton& skeleton, const HumanPose& pose,
                    double otherwise);

}  // namespace markerless_mocap
