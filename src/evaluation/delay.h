#pragma once

#include "evaluation/joint_track.h"

namespace markerless_mocap {

/// Delay of an estimate relative to the true motion.
struct Delay {
  double seconds;                 ///< positive: the estimate is late; NaN if it cannot be estimated
  double D_now_mm, D_shifted_mm;  ///< mean D without and with the shift, over the same frames, mm
};

/// Estimates the time shift of the truth, up to `max_seconds` in either direction, that minimises
/// D. The truth is interpolated linearly between its frames. The estimate needs 10 frames that stay
/// inside the truth's range under all shifts, and motion: D must change by 1 % over the shifts.
Delay estimateDelay(const JointTrack& truth, const JointTrack& estimate, double max_seconds = 0.5);

}  // namespace markerless_mocap
