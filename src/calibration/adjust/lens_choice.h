#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/adjust/rig_state.h"

namespace markerless_mocap {

/// The lens model that predicts views left out best, and what each model reached. Of models that
/// differ by less than half a percent, the simplest: the fisheye is simpler than the rational one,
/// and must be better by two percent than the others, as it is less common. With fifteen views and
/// more, p1 and p2 are always estimated: the views of one camera alone hardly show them, but they
/// turn the camera within the rig.
struct LensChoice {
  LensModel lens = LensModel::kPlumbBob;
  Intrinsics start{};  ///< of this model
  std::vector<LensTrial> trials;
};

/// \param views of this camera
LensChoice chooseLens(const Board& board, const CameraToCalibrate& camera,
                      const std::vector<const BoardView*>& views);

/// The lens of a camera from its own views. \param lens empty: chosen
/// \param intrinsics set to those of the lens
LensChoice lensFromViews(const Board& board, const CameraToCalibrate& camera,
                         const std::vector<const BoardView*>& views,
                         const std::optional<LensModel>& lens, Intrinsics* intrinsics);

/// Intrinsics from the views of one camera alone. Keeps `start` where the model has no coefficient.
Intrinsics adjustIntrinsics(const Board& board, const CameraToCalibrate& camera,
                            const std::vector<const BoardView*>& views, const Intrinsics& start,
                            LensModel lens);

}  // namespace markerless_mocap
