#include "contour/track/limbs_in_doubt.h"

#include <algorithm>
#include <numeric>

#include "contour/fit/body_overlap.h"

namespace markerless_mocap {
namespace {

// The masks may show limbs elsewhere if they overlap so much less than what the pose was fitted to,
// and do if the overlap rises by the second value.
constexpr double kLessOverlap = 0.03, kMinGain = 0.02;
constexpr RobustSchedule kSchedule{12, 0.15, 0.03};

/// Mean overlap of body and masks, see viewOverlap().
double overlapOf(const ContourObservation& seen, const CameraRig& rig, const ContourBody& body,
                 const ContourPose& pose) {
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(pose, frames);
  body.place(frames, cones);
  const std::vector<double> overlaps = viewOverlaps(seen, rig, cones);
  return std::accumulate(overlaps.begin(), overlaps.end(), 0.0) / std::max(1, seen.usableViews());
}

}  // namespace

std::optional<ContourFit> findLimbsInDoubt(const ContourMultiHypothesisTracker& tracker,
                                           const ContourObservation& seen, const CameraRig& rig,
                                           const ContourBody& body, const ContourFit& fit) {
  const double before = overlapOf(seen, rig, body, fit.pose);
  if (before > fit.overlap - kLessOverlap) return std::nullopt;
  ContourPose pose = fit.pose;
  for (int limb = ContourLimb::kLeftArm; limb < ContourLimb::kCount; ++limb)
    pose = tracker.searchLimb(seen, body, pose, ContourLimb::Id(limb)).value_or(pose);
  if (overlapOf(seen, rig, body, pose) < before + kMinGain) return std::nullopt;
  const ContourFit found = tracker.bestFit(seen, body, {pose}, kSchedule);
  if (found.status != ContourFitStatus::kFitted) return std::nullopt;
  return found;
}

}  // namespace markerless_mocap
