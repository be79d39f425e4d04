#pragma once

#include "checks/finding.h"
#include "checks/seen_rig.h"

namespace markerless_mocap {

/// Whether the silhouettes of a person who moves agree with the calibration and the stamps, and
/// whether the volume holds the person. Nothing if there are less than two calibrated cameras.
void checkMotion(const SeenRig& rig, Findings* findings);

/// Why checkMotion() says nothing; empty if it can judge.
std::string motionNotChecked(const SeenRig& rig);

}  // namespace markerless_mocap
