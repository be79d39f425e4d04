#pragma once

#include <optional>
#include <vector>

#include "checks/motion/explanation.h"

namespace markerless_mocap {

/// Where a person who goes less far is looked at from one side only by each camera: a turn or a
/// lens then cannot be told from what the silhouettes hold besides the person.
constexpr double kOneSpot = 0.3;  // m

/// How far apart the places are where the person was, m; without the outermost tenths.
double walkedIn(const std::vector<CameraState>& states);

}  // namespace markerless_mocap
