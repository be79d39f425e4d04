#pragma once

#include <array>
#include <vector>

#include "checks/seen_rig.h"

namespace markerless_mocap {

/// The brightness of what stands still, relative to its median over time, of one camera.
struct LightTrack {
  std::vector<double> seconds;               ///< since the first image
  std::vector<std::array<double, 3>> gains;  ///< of blue, green, red; 1: as usual
};

/// \param images with `colors`; others are passed over
LightTrack lightTrackOf(const std::vector<SeenImage>& images);

}  // namespace markerless_mocap
