#pragma once

#include "calibration/adjust/rig_state.h"
#include "calibration/calibrate.h"

namespace markerless_mocap {

/// Calibrations and residuals of all cameras.
RigCalibration summarise(const Board& board, const CalibrationInput& input, const RigState& state);

/// Fills in `verdict` and `good`.
void writeVerdict(const CalibrationInput& input, RigCalibration* result);

/// Offsets against the middle one of all cameras become part of the calibrations.
void keepOffsets(RigCalibration* result);

/// Moves the world so that the person of the input's walk trod on its floor.
void putFloorUnderWalk(const CalibrationInput& input, RigCalibration* result);

}  // namespace markerless_mocap
