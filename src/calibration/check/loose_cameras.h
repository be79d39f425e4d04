#pragma once

#include <optional>
#include <vector>

#include "calibration/adjust/bundle.h"
#include "calibration/adjust/rig_state.h"

namespace markerless_mocap {

/// A camera that did not stand still.
struct LooseCamera {
  size_t camera = 0;
  double time = 0.0;       ///< s: when its views begin to disagree
  bool later_part = true;  ///< the views after that time are left out, else those before it
  double pixels = 0.0;     ///< by how much its image moved
};

/// The camera whose residuals jump most at some time, if one does clearly: by more than a pixel and
/// by more than they scatter. The part with fewer views is the one that is left out.
std::optional<LooseCamera> loosestCamera(const Board& board, const RigState& state);

/// Finds all loose cameras, and marks the views of the parts that are left out as not used. The
/// state is adjusted again after each.
std::vector<LooseCamera> leaveOutLooseViews(const Board& board, const BundleOptions& options,
                                            RigState* state);

}  // namespace markerless_mocap
