#pragma once

#include "motion/gait/body_course.h"

namespace markerless_mocap {

/// Turns thighs, shanks, feet and toes so that the feet are where they belong. Hips must be posed.
void poseLegs(const BodyInstant& now, const HumanSkeleton& skeleton, HumanPose& pose);

/// How high the hips may be with a standing leg's knee still a little bent, metres; `otherwise` if
/// no foot stands. The hips' turn and horizontal place must be posed.
double highestHips(const BodyInstant& now, const HumanSkeleton& skeleton, const HumanPose& pose,
                   double otherwise);

}  // namespace markerless_mocap
