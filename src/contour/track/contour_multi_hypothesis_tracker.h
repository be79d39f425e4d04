#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "contour/track/contour_hypothesis_tracker.h"

namespace markerless_mocap {

/// Result of one frame: the active hypothesis.
struct ActiveTrack {
  ContourTrackingResult track;
  /// The pose does not continue that of the last frame: a start, or another hypothesis has become
  /// active.
  bool switched = false;
  /// Another start in this frame has led to the same pose, limbs and all.
  bool agreed = false;
  /// The pose has been found by a search in this frame.
  bool started = false;
};

/// Tracks the active hypothesis and, until it is decided, one alternative: front and back
/// exchanged, left and right exchanged, or the pose of the hull's pose tree. The one whose quality
/// is better over time becomes active. Not thread-safe.
class ContourMultiHypothesisTracker {
 public:
  ContourMultiHypothesisTracker(const CameraRig& rig, const ContourOptions& options);

  /// Starts at the best of several poses, with the mirrored pose as alternative.
  ActiveTrack start(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
                    const std::vector<ContourPose>& poses);
  ActiveTrack update(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
                     const MaySearch& may_search = {});
  /// See ContourHypothesisTracker::improve(). \return a better fit of the active hypothesis
  std::optional<ContourFit> improve(const ContourObservation& seen, const ContourBody& body);
  /// Starts a second time, on a frame after its update(). If the result is the same body, it
  /// confirms the active hypothesis. If the result is clearly better, it replaces it. \param active
  /// result of update()
  ActiveTrack reinitialize(int64_t stamp_ns, const ContourObservation& seen,
                           const ContourBody& body, const std::vector<ContourPose>& poses,
                           const ActiveTrack& active);
  /// Starts from a finished fit, without alternative.
  ActiveTrack startFrom(int64_t stamp_ns, const ContourFit& fit);
  /// Takes the best of several poses as alternative, unless there is one already.
  void proposeAlternative(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
                          const std::vector<ContourPose>& poses);
  /// See ContourHypothesisTracker::searchLimb().
  std::optional<ContourPose> searchLimb(const ContourObservation& seen, const ContourBody& body,
                                        const ContourPose& pose, ContourLimb::Id limb) const {
    return active_.searchLimb(seen, body, pose, limb);
  }
  /// The pose that update() would start from; empty while lost.
  std::optional<ContourPrediction> predict(int64_t stamp_ns) const {
    return active_.predict(stamp_ns);
  }
  /// See ContourHypothesisTracker::motion().
  std::optional<ContourMotion> motion(int64_t stamp_ns) const { return active_.motion(stamp_ns); }
  bool hasAlternative() const { return alternative_.has_value(); }
  /// True if a pose is tracked and there is no alternative, or the alternative has turned out
  /// clearly worse.
  bool isUnambiguous() const;
  /// True if no alternative has fitted better since it was proposed.
  bool isAhead() const { return active_.tracking() && (!alternative_ || alternative_gain_ <= 0); }
  /// Says that a start on a later frame has led to the same body.
  void confirm() { confirmed_ = true; }
  /// True if a start on a later frame has led to the same body.
  bool isConfirmed() const { return confirmed_; }
  void lose();
  /// From now on time goes backwards; an alternative is forgotten.
  void turnBack();
  /// See ContourHypothesisTracker::searchSoon().
  void searchSoon() { active_.searchSoon(); }
  /// The best of the fits that start at several poses, best first; at most kMaxFinalFits.
  std::vector<ContourFit> bestFits(const ContourObservation& seen, const ContourBody& body,
                                   std::vector<ContourPose> poses,
                                   const RobustSchedule& schedule = RobustSchedule::wide()) const;
  /// The first of bestFits().
  ContourFit bestFit(const ContourObservation& seen, const ContourBody& body,
                     std::vector<ContourPose> poses,
                     const RobustSchedule& schedule = RobustSchedule::wide()) const;

 private:
  /// The successful fits, best first.
  std::vector<ContourFit> fitsFrom(const ContourObservation& seen, const ContourBody& body,
                                   const std::vector<ContourPose>& poses,
                                   const RobustSchedule& schedule) const;
  void setAlternative(int64_t stamp_ns, const ContourFit& fit);

  ContourHypothesisTracker active_;
  std::optional<ContourHypothesisTracker> alternative_;
  /// Quality of the alternative minus that of the active hypothesis, summed over frames.
  double alternative_gain_ = 0.0;
  bool confirmed_ = false;
};

/// Whether the joints are nearly in the same places on average; an arm may be elsewhere.
bool isSameBody(const ContourBody& body, const ContourPose& pose, const ContourPose& other);

/// True if a hand or a foot is far from its position in the other pose.
bool limbsDiffer(const ContourBody& body, const ContourPose& pose, const ContourPose& other);

}  // namespace markerless_mocap
