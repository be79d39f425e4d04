#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "contour/regions/region_observer.h"
#include "contour/track/contour_multi_hypothesis_tracker.h"
#include "contour/track/moving_contours.h"
#include "contour/track/usual_quality.h"

namespace markerless_mocap {

/// A fitted pose, and what it is judged by.
struct JudgedPose {
  const ContourFit& fit;
  const ContourObservation& seen;
  const ContourMultiHypothesisTracker& hypotheses;
  const MovingContours& contours;
  bool of_mean_body;  ///< the person has not been measured
};

/// Whether a pose may be believed: how well it fits, whether colours and silhouettes show the same
/// person, and whether it fits as well as usual after something has gone wrong.
class PoseTrust {
 public:
  /// What the pose of this frame comes from.
  void take(const RegionObservation& found);
  /// True if silhouettes do not show the person that colours follow.
  bool isContradicted() const;
  /// By limb, see RegionMasks.
  const std::array<double, ContourLimb::kCount>& limbAgreement() const { return limb_agreement_; }

  /// Judges the pose of a start.
  void judgeStart(const JudgedPose& pose) { accepted_ = mayBeAccepted(pose); }
  /// Judges the same pose in a later frame: once accepted, it stays so until doubt().
  void judge(const JudgedPose& pose) { accepted_ = accepted_ || mayBeAccepted(pose); }
  bool isAccepted() const { return accepted_; }
  /// True if the pose has been accepted and the silhouettes of this frame set do not contradict it.
  bool isBelieved() const;
  /// Why a pose is not believed, or why it may not be told from another one; empty if it is and
  /// may.
  std::string whyUncertain(const ContourFit& fit,
                           const ContourMultiHypothesisTracker& hypotheses) const;

  /// For some time after a gap or a new start, a pose counts only if it fits as well as usual.
  void doubt(int64_t stamp_ns);
  /// Doubts a pose that fits far worse than usual, as where cameras are covered. Returns whether it
  /// does.
  bool doubtIfFarWorse(int64_t stamp_ns, const ContourFit& fit);
  /// Another start has led to the same pose: no need to doubt it if it fits nearly as usual.
  void agree(const ContourFit& fit);
  void endDoubt() { doubted_until_ns_ = 0; }
  bool isDoubted(int64_t stamp_ns, const ContourFit& fit) const;
  /// Learns how well the body usually fits.
  void learnQuality(int64_t stamp_ns, const ContourFit& fit);
  /// The body is another one.
  void forgetQuality() { usual_quality_.forget(); }

 private:
  bool mayBeAccepted(const JudgedPose& pose) const;

  // Of the last frame, see RegionMasks.
  double agreement_ = 1.0;
  std::array<double, ContourLimb::kCount> limb_agreement_{};
  bool accepted_ = false;       ///< since the last start or doubt
  UsualQuality usual_quality_;  ///< of poses that are not doubted
  int64_t doubted_until_ns_ = 0;
};

}  // namespace markerless_mocap
