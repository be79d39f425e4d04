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

/// The lens model that predicts views left out best, and what each model reached. Of models that
/// differ by less than half a percent, the simplest. With fifteen views and more, p1 and p2 are
/// always estimated: the views of one camera alone hardly show them, but they turn the camera
/// within the rig.
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
