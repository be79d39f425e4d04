#pragma once

#include <array>

#include "calibration/adjust/rig_state.h"

namespace markerless_mocap {

/// What is known of a lens before any view: its intrinsics are near `mean`, with standard
/// deviations `sigma`; infinite where nothing is known.
struct LensPrior {
  Intrinsics mean{}, sigma{};

  template <class T>
  bool operator()(const T* intrinsics, T* residual) const {
    for (size_t i = 0; i < mean.size(); ++i)
      residual[i] = T(noise / sigma[i]) * (intrinsics[i] - T(mean[i]));
    return true;
  }

  double noise = 0.3;  ///< pixels, of a corner, in whose units the residuals are
};

/// Of common lenses: the axis is near the middle of the image, p1 and p2 are small; other
/// coefficients have but the weakest of priors, for views that say nothing of them. Views of a
/// small part of the image let the axis move a long way with p1 and p2 and with the direction of
/// the camera.
LensPrior commonLens(const CameraState& camera, double noise);

}  // namespace markerless_mocap
