#pragma once

#include "motion/motion_script.h"
#include "motion/gait/body_course.h"

namespace markerless_mocap {

/// Turns hips, spine, chest, neck and head: what the script keys, what the gait adds, and the small
/// unrest of somebody who is alive.
void poseTrunk(const MotionScript& script, const BodyInstant& now, HumanPose& pose);

/// A slow wandering of about -1 to 1 that never repeats within minutes. \param stream tells
/// independent ones apart
double unrest(double seconds, int stream);

}  // namespace markerless_mocap
