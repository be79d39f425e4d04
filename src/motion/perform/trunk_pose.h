#pragma once

#include "motion/gait/gait_states.h"
#include "motion/motion_script.h"

namespace markerless_mocap {

/// Turns hips, spine, chest, neck and head: what the script keys, what the gait adds, and the small
/// unrest of somebody who is alive.
void poseTrunk(const MotionScript& script, const GaitState& now, HumanPose& pose);

/// A slow wandering of about -1 to 1 that never repeats within minutes. \param stream tells
/// independent ones apart
double idleNoise(double seconds, int stream);

}  // namespace markerless_mocap
