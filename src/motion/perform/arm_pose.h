#pragma once

#include "motion/gait/gait_states.h"
#include "motion/motion_script.h"

namespace markerless_mocap {

/// Poses clavicles, upper arms, forearms and hands, by joint angles or by targets of the hands,
/// blended as the script says. Hips and trunk must be posed before.
void poseArms(const MotionScript& script, const GaitState& now, const HumanSkeleton& skeleton,
              HumanPose& pose);

}  // namespace markerless_mocap
