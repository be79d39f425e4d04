#pragma once

#include <string>

#include "calibration/calibrate.h"

namespace markerless_mocap {

/// A self-contained HTML page: the verdict in plain words; per camera its lens, residuals and
/// uncertainties, its residuals over time and over the image; which cameras saw the board together.
std::string calibrationPage(const RigCalibration& result);

}  // namespace markerless_mocap
