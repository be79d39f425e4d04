#pragma once

#include <string>
#include <vector>

#include "contour/fit/contour_fitter.h"

namespace markerless_mocap {

/// Leaves out views whose silhouettes contradict those of most others, as of a camera that is
/// covered, out of focus or turned: they would pull limbs out of their places. Not thread-safe.
class ContradictedViews {
 public:
  void reset() { cameras_.clear(); }
  /// Which cameras are left out, for the user; empty if none is.
  std::string described(const CameraRig& rig) const;
  /// Leaves out the views that judge() has found: ViewStatus::kContradicted, without rays.
  void leaveOut(ContourObservation& seen) const;
  /// True if one of the views, by camera, is not left out.
  bool leaveAnyOf(std::vector<bool> views) const;
  /// Finds the views that the body of a fit covers far worse than most; at least three and more
  /// than half stay. \param seen what the body was fitted to. Returns whether there are such views
  /// that were not left out.
  bool judge(const CameraRig& rig, const ContourBody& body, const ContourObservation& seen,
             const ContourFit& fit);

 private:
  std::vector<size_t> cameras_;  ///< whose views are left out
};

}  // namespace markerless_mocap
