#pragma once

#include "checks/finding.h"
#include "checks/seen_rig.h"

namespace markerless_mocap {

/// Everything that is wrong with what cameras have sent, errors first. It looks at the messages, at
/// the stamps, at the pictures, at the calibration by itself, and at whether the silhouettes of
/// moving people agree with calibration and stamps. docs/checking.md lists the findings.
Findings checkRig(const SeenRig& rig);

/// What could not be judged, and why, as sentences: no person, no calibration, too short.
std::vector<std::string> notChecked(const SeenRig& rig);

}  // namespace markerless_mocap
