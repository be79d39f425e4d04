#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "contour/track/contour_hypothesis_tracker.h"

namespace markerless_mocap {

/// One instant of what is held true.
struct ActiveTrack {
  ContourTrackingResult track;
  bool switched = false;  ///< another hypothesis has taken the place of the one held before
};

/// Follows a pose and, for as long as it takes to decide, one that contradicts it: front for back,
/// left for right, or what the hull's pose tree says. The one that explains the masks better over
/// time is held true. Not thread-safe.
class ContourHypotheses {
 public:
  ContourHypotheses(const CameraRig& rig, const ContourOptions& options);

  /// Starts at the best of some poses, against its mirrored one.
  ActiveTrack start(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
                    const std::vector<ContourPose>& poses);
  ActiveTrack update(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body);
  /// Starts once more, from an instant after its update(): the same body confirms the one held,
  /// what explains the masks clearly better takes its place. \param held what update() gave
  ActiveTrack reinitialize(int64_t stamp_ns, const ContourObservation& seen,
                           const ContourBody& body, const std::vector<ContourPose>& poses,
                           const ActiveTrack& held);
  /// Lets the best of some poses contradict the one held, unless one does already.
  void proposeAlternative(int64_t stamp_ns, const ContourObservation& seen, const ContourBody& body,
                          const std::vector<ContourPose>& poses);
  bool hasAlternative() const { return alternative_.has_value(); }
  /// Whether nothing that contradicts the pose explains the masks nearly as well.
  bool isUnambiguous() const;
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
                                   const RobustSchedule& schedule) const;
  void letRival(int64_t stamp_ns, const ContourFit& fit);

  ContourTracker active_;
  std::optional<ContourTracker> alternative_;
  double alternative_gain_ =
      0.0;  ///< how much better the rival explains the masks, summed over instants
  bool confirmed_ = false;
};

/// Whether a hand or a foot is far from where it is in the other pose.
bool limbsDiffer(const ContourBody& body, const ContourPose& pose, const ContourPose& other);

/// The pose of a body that fills the same space turned about: front becomes back, and what was the
/// left limb's place is the right one's. Knees and ankles straighten, as they bend to one side
/// only.
ContourPose mirrored(const ContourBody& body, const ContourPose& pose);

/// The pose with each leg where the other was.
ContourPose withLegsSwapped(const ContourBody& body, const ContourPose& pose);

}  // namespace markerless_mocap
