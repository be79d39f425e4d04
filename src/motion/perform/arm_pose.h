#pragma once

#include "motion/gait/gait_states.h"
#include "motion/motion_script.h"

namespace markerless_mocap {

/// Turns clavicles, upper arms, forearms and hands: by the joints' angles, or as far as the script
/// asks by where the hands are to be. Hips and trunk must be posed.
void poseArms(const MotionScript& script, const GaitState& now, const HumanSkeleton& skeleton,
              HumanPose& pose);

}  // namespace markerless_mocap
