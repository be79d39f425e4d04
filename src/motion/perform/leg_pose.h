#pragma once

#include "motion/gait/gait_states.h"

namespace markerless_mocap {

/// Turns thighs, shanks, feet and toes so that the feet are where they belong. Hips must be posed.
void poseLegs(const GaitState& now, const HumanSkeleton& skeleton, HumanPose& pose);

/// How high the hips may be with a standing leg's knee still a little bent, metres; `otherwise` if
/// no foot stands. The hips' turn and horizontal place must be posed.
double maxHipHeight(const GaitState& now, const HumanSkeleton& skeleton, const HumanPose& pose,
                    double otherwise);

}  // namespace markerless_mocap
