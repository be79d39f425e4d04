#pragma once

#include "contour/fit/contour_fitter.h"

namespace markerless_mocap {

/// Leaves out views whose silhouettes contradict those of most others, as of a camera that is
/// covered, out of focus or turned: they would pull limbs out of their places. Not thread-safe.
class ContradictedViews {
 public:
  void reset() { *this = ContradictedViews(); }
  /// Whether there may be such views in the next frame.
  void note(const ContourFit& fit);
  /// Leaves out each view in which the body covers the silhouette far worse than in most others, if
  /// a view is suspected. More than half of the views stay, and at least three.
  /// \param expected the pose that is predicted
  void leaveOut(const CameraRig& rig, const ContourBody& body, const ContourPose& expected,
                ContourObservation& seen);

 private:
  bool suspected_ = false, some_left_out_ = false;
};

}  // namespace markerless_mocap
