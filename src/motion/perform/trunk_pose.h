#pragma once

#include "motion/gait/gait_states.h"
#include "motion/motion_script.h"

namespace markerless_mocap {

/// Poses hips, spine, chest, neck and head: the script's keys, the contribution of the gait, and
/// small idle motions.
void poseTrunk(const MotionScript& script, const GaitState& now, HumanPose& pose);

/// Slow noise of about -1 to 1 that does not repeat within minutes.
/// \param stream number of an independent noise signal
double idleNoise(double seconds, int stream);

}  // namespace markerless_mocap
