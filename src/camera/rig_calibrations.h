#pragma once

#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The calibrations of a rig's cameras.
inline std::vector<CameraCalibration> calibrationsOf(const CameraRig& rig) {
  std::vector<CameraCalibration> calibrations;
  for (const Camera& camera : rig) calibrations.push_back(camera.calibration());
  return calibrations;
}

}  // namespace markerless_mocap
