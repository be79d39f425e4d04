#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "contour/fit/contour_fitter.h"
#include "contour/fit/view_times.h"

namespace markerless_mocap {

/// kTracked: the pose continues the last one. kLimbRecovered: a limb was lost and has been found in
/// this frame. kLimbLost: a limb does not agree with the masks and no better position was found.
/// kLost: there is no pose; call start().
enum class ContourTrackingStatus { kLost, kTracked, kLimbRecovered, kLimbLost };
const char* toString(ContourTrackingStatus status);

/// Result of one frame.
struct ContourTrackingResult {
  ContourTrackingStatus status = ContourTrackingStatus::kLost;
  ContourFit fit;  ///< valid unless lost
};

/// A search for limbs takes as long as following the person over many frames.
enum class Effort {
  kFollow,  ///< limbs that are lost stay so
  kSearch,
};

/// Tracks one hypothesis of the pose: predicts and fits. If the fit becomes worse than usual or a
/// limb leaves the masks, it also tries the last pose and other positions of limbs. At intervals it
/// also searches the least certain limb and, if the trunk is twisted, fits without the twist. It
/// keeps the pose with the best quality. Not thread-safe.
class ContourHypothesisTracker {
 public:
  /// Throws std::invalid_argument if an option is out of range.
  ContourHypothesisTracker(const CameraRig& rig, const ContourOptions& options);

  /// The best fit from a pose that may be wrong by tenths of a radian and decimetres. Other
  /// positions of its limbs are tried, too.
  ContourFit search(const ContourObservation& seen, const ContourBody& body,
                    const ContourPose& pose) const;
  /// Another place of one limb that fits better; empty if there is none. \param pose a fitted one
  std::optional<ContourPose> searchLimb(const ContourObservation& seen, const ContourBody& body,
                                        const ContourPose& pose, ContourLimb::Id limb) const;
  /// (Re)starts at a pose that may be wrong by tenths of a radian and decimetres. Other positions
  /// of its limbs are tried, too. The status is kTracked or, if the overlap is too small, kLost.
  ContourTrackingResult start(int64_t stamp_ns, const ContourObservation& seen,
                              const ContourBody& body, const ContourPose& pose);
  /// Starts from a finished fit, without a search.
  ContourTrackingResult startFrom(int64_t stamp_ns, const ContourFit& fit);
  /// Tracks to the next frame. The track is lost if the stamp is not later than the last one, or
  /// more than half a second later. The shape of the body may change between frames.
  ContourTrackingResult update(int64_t stamp_ns, const ContourObservation& seen,
                               const ContourBody& body, Effort effort = Effort::kSearch);
  /// The pose that update() would start from; empty while lost.
  std::optional<ContourPrediction> predict(int64_t stamp_ns) const;
  /// The motion that the prediction follows; empty if two poses do not tell it.
  std::optional<ContourMotion> motion(int64_t stamp_ns) const;
  void lose() { last_.reset(); }
  /// Lets the next frame search for limbs, however short ago that was done.
  void searchSoon() { next_search_ns_ = next_least_certain_ns_ = 0; }
  bool tracking() const { return last_.has_value(); }
  /// Usual quality of the fits, 0 to 1: mean of overlap and explained rays; 0 while lost.
  double quality() const { return last_ ? last_->quality : 0.0; }
  /// The last pose; valid only while tracking.
  const ContourPose& pose() const { return last_->pose; }
  const ContourFitter& fitter() const { return fitter_; }

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
  ContourTrackingResult keep(int64_t stamp_ns, const ContourFit& fit, ContourTrackingStatus status);
  /// Limbs that lie outside the masks by more than usual; all limbs if the fit is worse than usual.
  std::array<bool, ContourLimb::kCount> suspicious(const ContourFit& fit) const;
  std::vector<ContourPose> limbAlternatives(const ContourObservation& seen, const ContourBody& body,
                                            ContourLimb::Id limb, const ContourFit& fit,
                                            const ContourPose& expected) const;
  // The following functions replace `fit` if they find a better one, and return whether they did.
  bool tryPoses(const ContourObservation& seen, const ContourBody& body,
                const std::vector<ContourPose>& starts,
                const std::optional<ContourPrediction>& prediction, double gain,
                ContourFit& fit) const;
  bool retry(const ContourObservation& seen, const ContourBody& body,
             const ContourPrediction& prediction, Effort effort, ContourFit& fit) const;
  bool searchLeastCertainLimb(const ContourObservation& seen, const ContourBody& body,
                              const ContourPrediction& prediction, ContourFit& fit) const;
  bool untwist(const ContourObservation& seen, const ContourBody& body,
               const ContourPrediction& prediction, ContourFit& fit) const;

  CameraRig rig_;
  ContourFitter fitter_;
  std::optional<Past> last_;
  /// Earliest times of the next search for suspicious limbs, of that for the least certain limb,
  /// and of the next fit without twist.
  int64_t next_search_ns_ = 0, next_least_certain_ns_ = 0, next_untwist_ns_ = 0;
};

}  // namespace markerless_mocap
