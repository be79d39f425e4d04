#pragma once

#include "checks/finding.h"
#include "checks/seen_rig.h"

namespace markerless_mocap {

/// The stamps of each camera and between cameras: zero, backwards, doubled, irregular, as received,
/// gaps, other rates, no time in common; images that repeat.
void checkStamps(const SeenRig& rig, Findings* findings);

}  // namespace markerless_mocap
