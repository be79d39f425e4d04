#pragma once

#include "evaluation/joint_track.h"

namespace markerless_mocap {

/// How late an estimate shows the motion.
struct Delay {
  double seconds;  ///< positive: the estimate shows what was; NaN when it cannot be told
  double D_now_mm, D_shifted_mm;  ///< mean D without and with the shift, over the same frames
};

/// The shift of the truth in time, at most `most_seconds` either way, at which D is least; the
/// truth is linear between its frames. To be told it takes 10 frames that stay within the truth
/// under every shift, and a motion: D must change by 1 % over the shifts.
Delay estimateDelay(const JointTrack& truth, const JointTrack& estimate, double most_seconds = 0.5);

}  // namespace markerless_mocap
