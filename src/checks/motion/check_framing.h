#pragma once

#include "checks/finding.h"
#include "checks/motion/rig_model.h"

namespace markerless_mocap {

/// Whether the borders of the images cut off the legs or the head of a person, in all cameras but
/// one at most and for most of the time.
void checkFraming(const RigSight& sight, const RigModel& model, Findings* findings);

}  // namespace markerless_mocap
