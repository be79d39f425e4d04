#pragma once

#include "calibration/adjust/rig_state.h"
#include "calibration/calibrate.h"

namespace markerless_mocap {

/// Calibrations and residuals of all cameras.
RigCalibration summarise(const Board& board, const CalibrationInput& input, const RigState& state);

/// Fills in `verdict` and `good`.
void writeVerdict(const CalibrationInput& input, RigCalibration* result);

}  // namespace markerless_mocap
