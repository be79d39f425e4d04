#pragma once

#include <string>
#include <vector>

#include "calibration/calibrate.h"

namespace markerless_mocap {

/// Writes rig.yaml, camera_info/<camera>.yaml, cameras.launch and report.html into a folder, which
/// is made if it is not there. Throws std::runtime_error if a file cannot be written.
void writeCalibration(const std::string& folder, const RigCalibration& result,
                      const std::string& world_frame);

/// Writes only camera_info/<camera>.yaml and report.html: the cameras have no place.
void writeLenses(const std::string& folder, const RigCalibration& result);

}  // namespace markerless_mocap
