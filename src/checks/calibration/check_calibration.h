#pragma once

#include "checks/finding.h"
#include "checks/seen_rig.h"

namespace markerless_mocap {

/// camera_info and tf of each camera, as far as they tell by themselves.
void checkMessages(const SeenRig& rig, Findings* findings);

/// The rig by its geometry alone: units, up, cameras in one place, a volume in common.
void checkGeometry(const SeenRig& rig, Findings* findings);

}  // namespace markerless_mocap
