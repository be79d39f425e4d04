#pragma once

#include <string>
#include <vector>

#include "calibration/adjust/rig_state.h"

namespace markerless_mocap {

/// How well a lens model predicts views that it was not estimated from.
struct LensTrial {
  LensModel lens = LensModel::kNone;
  double rms = 0.0;  ///< pixels, on views left out
};

/// The simplest lens model that predicts views left out as well as the best one, within one
/// standard error of the difference, and what each model reached. Source: Hastie, Tibshirani and
/// Friedman, The Elements of Statistical Learning, 7.10.
struct LensChoice {
  LensModel lens = LensModel::kPlumbBob;
  std::vector<LensTrial> trials;
};

/// \param views of this camera
/// \param start first intrinsics
LensChoice chooseLens(const Board& board, const std::vector<const BoardView*>& views,
                      const Intrinsics& start);

/// Intrinsics from the views of one camera alone. Keeps `start` where the model has no coefficient.
Intrinsics adjustIntrinsics(const Board& board, const std::vector<const BoardView*>& views,
                            const Intrinsics& start, LensModel lens);

}  // namespace markerless_mocap
