#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "contour/track/pose_history.h"
#include "contour/track/rival_poses.h"
#include "contour/track/search_times.h"

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

/// Whether there is time for a search of a limb, which takes as long as following the person over
/// some frames; without it limbs that are lost stay so. Empty: always.
using MaySearch = std::function<bool()>;

/// Tracks one hypothesis of the pose: predicts and fits. If the fit becomes worse than usual or a
/// limb leaves the masks, it also tries the last pose and other positions of limbs. At intervals
/// improve() searches the least certain limb and, if the trunk is twisted, fits without the twist.
/// It keeps the pose with the best quality. Not thread-safe.
class ContourHypothesisTracker {
 public:
  /// Throws std::invalid_argument if an option is out of range.
  ContourHypothesisTracker(const CameraRig& rig, const ContourOptions& options);

  /// The best fit from a pose that may be wrong by tenths of a radian and decimetres. Other
  /// positions of its limbs are tried, too.
  ContourFit search(const ContourObservation& seen, const ContourBody& body,
                    const ContourPose& pose) const {
    return rivals_.search({seen, body}, pose);
  }
  /// See RivalPoses::searchLimb().
  std::optional<ContourPose> searchLimb(const ContourObservation& seen, const ContourBody& body,
                                        const ContourPose& pose, ContourLimb::Id limb) const {
    return rivals_.searchLimb({seen, body}, pose, limb);
  }
  /// (Re)starts at a pose that may be wrong by tenths of a radian and decimetres. Other positions
  /// of its limbs are tried, too. The status is kTracked or, if the overlap is too small, kLost.
  ContourTrackingResult start(int64_t stamp_ns, const ContourObservation& seen,
                              const ContourBody& body, const ContourPose& pose);
  /// Starts from a finished fit, without a search.
  ContourTrackingResult startFrom(int64_t stamp_ns, const ContourFit& fit);
  /// Tracks to the next frame. The track is lost if the stamp is not later than the last one, or
  /// more than half a second later. The shape of the body may change between frames.
  ContourTrackingResult update(int64_t stamp_ns, const ContourObservation& seen,
                               const ContourBody& body, const MaySearch& may_search = {});
  /// Looks for a better fit to the frame of the last update() at intervals, whether or not its
  /// result is suspicious, for the sake of later frames. Returns it if there is one.
  std::optional<ContourFit> improve(const ContourObservation& seen, const ContourBody& body);
  /// The pose that update() would start from; empty while lost.
  std::optional<ContourPrediction> predict(int64_t stamp_ns) const {
    return history_.predict(stamp_ns);
  }
  /// See PoseHistory::motion().
  std::optional<ContourMotion> motion(int64_t stamp_ns) const { return history_.motion(stamp_ns); }
  void lose() {
    history_.forget();
    updated_.reset();
  }
  void turnBack() { history_.turnBack(); }
  /// Lets the next frame search for limbs, however short ago that was done.
  void searchSoon();
  bool tracking() const { return !history_.empty(); }
  /// Usual quality of the fits, 0 to 1: mean of overlap and explained rays; 0 while lost.
  double quality() const { return history_.quality(); }
  /// The last pose; valid only while tracking.
  const ContourPose& pose() const { return history_.last(); }
  const ContourFitter& fitter() const { return rivals_.fitter(); }

 private:
  /// An update(), for improve().
  struct Updated {
    int64_t stamp_ns;
    PoseHistory before;
    ContourPrediction prediction;
    ContourFit fit;
  };

  ContourTrackingResult keep(int64_t stamp_ns, const ContourFit& fit, ContourTrackingStatus status);
  /// Replaces a suspicious fit if a better one is found.
  ContourTrackingStatus repair(int64_t stamp_ns, const FittedFrame& now,
                               const ContourPrediction& prediction, const MaySearch& may_search,
                               ContourFit* fit);
  /// Tries other places of the suspicious limbs; returns whether the fit has been replaced, here or
  /// before (`better`).
  bool searchSuspiciousLimbs(int64_t stamp_ns, const FittedFrame& now,
                             const ContourPrediction& prediction, const MaySearch& may_search,
                             bool better, ContourFit* fit);

  RivalPoses rivals_;
  PoseHistory history_;
  std::optional<Updated> updated_;  ///< empty after a start, and while lost
  size_t next_limb_ = 0;            ///< where a search of suspicious limbs goes on
  SearchTimer suspicious_, least_certain_, untwist_;  ///< which rivals are tried when
};

}  // namespace markerless_mocap
