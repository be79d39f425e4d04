#pragma once

#include "checks/finding.h"
#include "checks/seen_rig.h"

namespace markerless_mocap {

/// Brightness over time: flicker, exposure and white balance that wander, a light that is switched.
void checkLight(const SeenRig& rig, Findings* findings);

/// Single pictures: dark, overexposed, covered, blurred.
void checkSharpness(const SeenRig& rig, Findings* findings);

/// Whether what stands still has moved in the image.
void checkMovedCameras(const SeenRig& rig, Findings* findings);

}  // namespace markerless_mocap
