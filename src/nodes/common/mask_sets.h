#pragma once

#include <string>
#include <utility>
#include <vector>

#include "camera/timing_remarks.h"

namespace markerless_mocap {

/// How silhouettes are joined into frame sets. Whoever joins the same silhouettes in this way gets
/// frame sets with the same stamps. \param tolerance, deadline seconds
/// \param offsets of the cameras' clocks, s; empty: they agree
inline AssemblerOptions maskSetOptions(double tolerance, double deadline,
                                       std::vector<double> offsets) {
  constexpr double kSilence = 0.3;  // s until frame sets no longer wait for a camera
  constexpr int kMaxMissed = 5;  // frame sets until they no longer wait for one with other stamps
  AssemblerOptions options;
  options.tolerance = tolerance;
  options.deadline = deadline;
  options.min_streams = 1;  // so that frame sets with too few cameras are told, too
  options.offsets = std::move(offsets);
  if (!options.offsets.empty()) options.max_drift = kFollowedDrift;
  options.silence = kSilence;
  options.max_missed = kMaxMissed;
  options.out_of_step = OutOfStep::kJoinIfNever;
  return options;
}

/// Why a frame set is not used.
inline std::string lackOfMasks(size_t present, size_t cameras, size_t required) {
  return "the frame set has the masks of " + std::to_string(present) + " of " +
         std::to_string(cameras) + " cameras, at least " + std::to_string(required) +
         " are needed within the deadline";
}

}  // namespace markerless_mocap
