#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "body/body_fixture.h"
#include "capture/virtual_studio.h"

namespace markerless_mocap {

inline StudioFiles packageFiles() {
  return {humanTemplate(), std::string(MOCAP_SOURCE_DIR) + "/config/motions"};
}

inline StudioOptions smallStudio() {
  StudioOptions options;
  options.rig = "ring4";
  options.width = 160;
  options.height = 120;
  options.background_frames = 3;
  options.duration = 2.0;
  return options;
}

}  // namespace markerless_mocap
