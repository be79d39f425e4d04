#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "contour/track/contour_tracker.h"

namespace markerless_mocap {

/// One instant of what is held true.
struct HeldTrack {
  ContourTrack track;
  bool jumped = false;  ///< another hypothesis has taken the place of the one held before
};

/// Follows a pose and, for as long as it takes to decide, one that contradicts it: front for back,
/// left for right, or what the hull's pose tree says. The one that explains the masks better over
/// time is held true. Not thread-safe.
class ContourHypotheses {
 public:
  ContourHypotheses(const CameraRig& rig, const ContourOptions& options);

  /// Starts at the best of some poses, against its mirrored one.
  HeldTrack start(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
                  const std::vector<ContourPose>& poses);
  HeldTrack update(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body);
  /// Starts once more, from an instant after its update(): the same body confirms the one held,
  /// what explains the masks clearly better takes its place. \param held what update() gave
  HeldTrack startAgain(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
                       const std::vector<ContourPose>& poses, const HeldTrack& held);
  /// Lets the best of some poses contradict the one held, unless one does already.
  void challenge(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
                 const std::vector<ContourPose>& poses);
  bool isChallenged() const { return rival_.has_value(); }
  /// Whether nothing that contradicts the pose explains the masks nearly as well.
  bool isAhead() const;
  /// Whether a start from a later instant has led to the body that is held.
  bool isConfirmed() const { return confirmed_; }
  void lose();
  /// The best of the fits that begin at some poses.
  ContourFit bestFit(const ContourObservation& seen, const ContourBody& body,
                     std::vector<ContourPose> poses) const;

 private:
  /// Those that succeed, the best first.
  std::vector<ContourFit> fitsFrom(const ContourObservation& seen, const ContourBody& body,
                                   const std::vector<ContourPose>& poses,
                                   const FitSchedule& schedule) const;
  void letRival(int64_t stamp_ns, const ContourFit& fit);

  ContourTracker held_;
  std::optional<ContourTracker> rival_;
  double rival_gain_ = 0.0;  ///< how much better the rival explains the masks, summed over instants
  bool confirmed_ = false;
};

/// Whether a hand or a foot is far from where it is in the other pose.
bool isElsewhere(const ContourBody& body, const ContourPose& pose, const ContourPose& other);

/// The pose of a body that fills the same space turned about: front becomes back, and what was the
/// left limb's place is the right one's. Knees and ankles straighten, as they bend to one side
/// only.
ContourPose mirrored(const ContourBody& body, const ContourPose& pose);

/// The pose with each leg where the other was.
ContourPose withLegsExchanged(const ContourBody& body, const ContourPose& pose);

}  // namespace markerless_mocap
