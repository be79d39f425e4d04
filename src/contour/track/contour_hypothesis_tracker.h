#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "contour/fit/contour_fitter.h"

namespace markerless_mocap {

/// kTracked: follows the last pose. kLimbRecovered: a limb was lost and has been found again in
/// this instant. kLimbLost: a limb is not where masks are and no better place was found. kLost:
/// there is no pose; start() is needed.
enum class ContourTrackingStatus { kLost, kTracked, kLimbRecovered, kLimbLost };
const char* toString(ContourTrackingStatus status);

/// One instant of a track.
struct ContourTrackingResult {
  ContourTrackingStatus status = ContourTrackingStatus::kLost;
  ContourFit fit;  ///< meaningful unless lost
};

/// Follows one body from instant to instant: predicts, fits, and when the body no longer covers the
/// masks as it did, also tries the last pose and other places of the limbs that stick out or lack
/// their rays, or the trunk without its twist, and keeps what covers the masks best. Not
/// thread-safe.
class ContourTracker {
 public:
  /// Throws std::invalid_argument if the options do.
  ContourTracker(const CameraRig& rig, const ContourOptions& options);

  /// (Re)starts at a pose that may be off by tenths of a radian and decimetres; its limbs are
  /// looked for elsewhere, too. What status the result has, the overlap decides: kTracked or kLost.
  ContourTrackingResult start(int64_t stamp_ns, const ContourObservation& seen,
                              const ContourBody& body, const ContourPose& pose);
  /// The same from a fit that needs no more looking.
  ContourTrackingResult startFrom(int64_t stamp_ns, const ContourFit& fit);
  /// The next instant. A stamp not after the last one, and one more than half a second after it,
  /// loses the track. Sizes of the body may change in between.
  ContourTrackingResult update(int64_t stamp_ns, const ContourObservation& seen,
                               const ContourBody& body);
  void lose() { last_.reset(); }
  bool tracking() const { return last_.has_value(); }
  /// How well the body usually explains the masks, 0 to 1: mean of overlap and rays explained; 0
  /// while lost.
  double quality() const { return last_ ? last_->quality : 0.0; }
  /// The last pose. Only while tracking.
  const ContourPose& pose() const { return last_->pose; }
  const ContourFitter& fitter() const { return fitter_; }

 private:
  struct Past {
    int64_t stamp_ns;
    ContourPose pose;
    std::optional<ContourPose> before;  ///< one frame time earlier
    double quality;                     ///< of the fit, as it usually is at best
    double below;                       ///< by which it usually is worse
    /// By which limbs stick out of masks, as they usually do, metres.
    std::array<double, ContourLimb::kCount> outside;
  };
  ContourTrackingResult keep(int64_t stamp_ns, const ContourFit& fit, ContourTrackingStatus status);
  /// Limbs that stick out of masks more than usual, or all when the fit is worse than usual.
  std::array<bool, ContourLimb::kCount> suspicious(const ContourFit& fit) const;
  std::vector<ContourPose> limbAlternatives(const ContourObservation& seen, const ContourBody& body,
                                            ContourLimb::Id limb, const ContourFit& fit,
                                            const ContourPose& expected) const;
  // These replace `fit` by what is clearly better and say whether they did.
  bool tryPoses(const ContourObservation& seen, const ContourBody& body,
                const std::vector<ContourPose>& starts,
                const std::optional<ContourPrediction>& prediction, double gain,
                ContourFit& fit) const;
  bool retry(const ContourObservation& seen, const ContourBody& body,
             const ContourPrediction& prediction, ContourFit& fit) const;
  bool searchLeastCertainLimb(const ContourObservation& seen, const ContourBody& body,
                              const ContourPrediction& prediction, ContourFit& fit) const;
  bool untwist(const ContourObservation& seen, const ContourBody& body,
               const ContourPrediction& prediction, ContourFit& fit) const;

  CameraRig rig_;
  ContourFitter fitter_;
  std::optional<Past> last_;
  int64_t next_search_ns_ = 0;   ///< suspicious limbs are not looked for again before
  int64_t next_look_ns_ = 0;     ///< nor is the one that the least speaks for
  int64_t next_untwist_ns_ = 0;  ///< nor are shoulders laid over the hips
};

}  // namespace markerless_mocap
