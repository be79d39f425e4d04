#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "contour/fit/contour_fitter.h"
#include "contour/fit/view_times.h"

namespace markerless_mocap {

/// One flag for each limb.
using LimbFlags = std::array<bool, ContourLimb::kCount>;
bool any(const LimbFlags& limbs);

/// The last poses of a track, and how well it usually fits: what the next frame is expected to be.
class PoseHistory {
 public:
  bool empty() const { return !last_; }
  void forget() { last_.reset(); }
  /// Adds the fit of the next frame.
  void add(int64_t stamp_ns, const ContourFit& fit);
  /// From now on the body moves in the opposite direction.
  void turnBack();

  /// The last pose; valid only if there is one.
  const ContourPose& last() const { return last_->pose; }
  /// Usual quality of the fits, see qualityOf(); 0 if there are none.
  double quality() const { return last_ ? last_->quality : 0.0; }

  /// The pose at a later time; empty without a pose, or if it is more than half a second old.
  std::optional<ContourPrediction> predict(int64_t stamp_ns) const;
  /// The motion that the prediction follows; empty if two poses do not tell it.
  std::optional<ContourMotion> motion(int64_t stamp_ns) const;
  /// Limbs that lie outside the masks by more than usual; all limbs if the fit is worse than usual.
  LimbFlags suspicious(const ContourFit& fit) const;

 private:
  struct Past {
    int64_t stamp_ns;
    ContourPose pose;
    std::optional<ContourPose> before;  ///< pose of the frame before
    int64_t before_ns;                  ///< its stamp
    double quality;                     ///< slowly decaying maximum of the quality
    double quality_deviation;           ///< usual difference from this maximum
    /// Usual distance of each limb outside the masks, metres.
    std::array<double, ContourLimb::kCount> outside;
  };

  std::optional<Past> last_;
};

}  // namespace markerless_mocap
