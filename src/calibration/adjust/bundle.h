#pragma once

#include <set>

#include "calibration/adjust/rig_state.h"

namespace markerless_mocap {

/// What an adjustment estimates.
struct BundleOptions {
  bool estimate_intrinsics = true;  ///< except those that are fixed
  bool estimate_offsets = false;    ///< time offsets
  /// Cameras whose pose and time offset are kept. If there are none, the first camera's offset is.
  std::set<size_t> held;
  double loss_pixels = 2.0;  ///< scale of the robust loss (Cauchy)
  int iterations = 60;
  int threads = 1;
};

/// Minimises the reprojection error of all used corners and known points over intrinsics, poses of
/// cameras and boards, and time offsets. Source: Triggs et al., Bundle adjustment: a modern
/// synthesis (2000). Throws std::runtime_error if the minimisation fails.
void adjustBundle(const Board& board, const BundleOptions& options, RigState* state);

/// Standard deviation of one coordinate of a corner, pixels, from the median of the residuals.
double robustSigma(const Board& board, const RigState& state);

/// Marks corners whose residual is larger than `limit` pixels as not used, and all others as used.
/// \return number of corners not used
int markOutliers(const Board& board, double limit, RigState* state);

}  // namespace markerless_mocap
