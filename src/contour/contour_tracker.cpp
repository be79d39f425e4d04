#include "markerless_mocap/contour/contour_tracker.h"

#include <algorithm>

#include "contour/limb_search.h"

namespace markerless_mocap {
namespace {

constexpr double kVelocityKept = 0.7;  // of the last frame's, in the prediction
constexpr int64_t kLongestGap_ns = 500000000;

// Overlap: below the first there is no person there; a drop by the second below what is usual is
// suspicious; another pose must be better by the third to be taken; the usual value follows by the
// share.
constexpr double kLostOverlap = 0.65, kOverlapDrop = 0.02, kOverlapGain = 0.004;
constexpr double kUsualShare = 0.1;

constexpr double kLimbOutside = 0.035;  // metres, mean over its balls: where limbs that fit are not

constexpr double kLooser = 5.0;  // is the prediction when a limb is looked for

constexpr FitSchedule kRetry{10, 0.12, 0.03};

bool any(const std::array<bool, ContourLimb::kCount>& limbs) {
  return std::any_of(limbs.begin(), limbs.end(), [](bool limb) { return limb; });
}

}  // namespace

const char* toString(ContourTrackStatus status) {
  constexpr const char* kNames[] = {"lost", "tracked", "recovered", "doubtful"};
  return kNames[size_t(status)];
}

ContourTracker::ContourTracker(const CameraRig& rig, const ContourOptions& options)
    : rig_(rig), fitter_(rig, options) {}

ContourTrack ContourTracker::keep(int64_t stamp_ns, const ContourFit& fit,
                                  ContourTrackStatus status) {
  if (fit.status != ContourFitStatus::kFitted || fit.overlap < kLostOverlap) {
    last_.reset();
    return {ContourTrackStatus::kLost, fit};
  }
  Past past{stamp_ns, fit.pose, std::nullopt, fit.overlap};
  if (last_) {
    past.before = last_->pose;
    // Rises at once and falls slowly, so that a loss does not become what is usual.
    past.overlap =
        std::max(fit.overlap, last_->overlap + kUsualShare * (fit.overlap - last_->overlap));
  }
  last_ = past;
  return {status, fit};
}

ContourTrack ContourTracker::start(int64_t stamp_ns, const ContourObservation& seen,
                                   const ContourBody& body, const ContourPose& pose) {
  last_.reset();
  ContourFit fit = fitter_.fit(seen, body, pose, std::nullopt, FitSchedule::wide());
  // Proposals often lack arms, and an arm at rest may hide one that is elsewhere.
  for (int limb = ContourLimb::kLeftArm; limb < ContourLimb::kCount; ++limb)
    if (fit.status == ContourFitStatus::kFitted)
      tryOtherPlaces(seen, body, ContourLimb::Id(limb), fit.pose, std::nullopt, fit);
  return keep(stamp_ns, fit, ContourTrackStatus::kTracked);
}

std::array<bool, ContourLimb::kCount> ContourTracker::suspicious(const ContourFit& fit) const {
  std::array<bool, ContourLimb::kCount> limbs{};
  const bool dropped = fit.overlap < last_->overlap - kOverlapDrop;
  for (size_t i = ContourLimb::kLeftArm; i < ContourLimb::kCount; ++i)
    limbs[i] = dropped || fit.limbs[i].outside > kLimbOutside;
  return limbs;
}

bool ContourTracker::tryPose(const ContourObservation& seen, const ContourBody& body,
                             const ContourPose& start,
                             const std::optional<ContourPrediction>& prediction,
                             ContourFit& fit) const {
  const ContourFit other = fitter_.fit(seen, body, start, prediction, kRetry);
  const bool better =
      other.status == ContourFitStatus::kFitted && other.overlap > fit.overlap + kOverlapGain;
  if (better) fit = other;
  return better;
}

bool ContourTracker::tryOtherPlaces(const ContourObservation& seen, const ContourBody& body,
                                    ContourLimb::Id limb, const ContourPose& expected,
                                    const std::optional<ContourPrediction>& prediction,
                                    ContourFit& fit) const {
  bool better = false;
  for (const ContourPose& place :
       otherPlaces(seen, rig_, fitter_.options(), body, fit.pose, expected, limb))
    better |= tryPose(seen, body, place, prediction, fit);
  return better;
}

bool ContourTracker::retry(const ContourObservation& seen, const ContourBody& body,
                           const ContourPrediction& prediction, ContourFit& fit) const {
  const ContourPrediction loose{prediction.pose, kLooser * prediction.seconds};
  bool better = tryPose(seen, body, last_->pose, loose, fit);
  for (size_t i = ContourLimb::kLeftArm; i < ContourLimb::kCount; ++i) {
    if (better && !any(suspicious(fit))) break;
    if (suspicious(fit)[i])
      better |= tryOtherPlaces(seen, body, ContourLimb::Id(i), prediction.pose, loose, fit);
  }
  return better;
}

ContourTrack ContourTracker::update(int64_t stamp_ns, const ContourObservation& seen,
                                    const ContourBody& body) {
  const int64_t gap = last_ ? stamp_ns - last_->stamp_ns : 0;
  if (!last_ || gap <= 0 || gap > kLongestGap_ns) {
    last_.reset();
    return {};
  }
  const ContourPrediction prediction{
      last_->before ? goneOn(*last_->before, last_->pose, kVelocityKept) : last_->pose,
      1e-9 * double(gap)};
  ContourFit fit = fitter_.fit(seen, body, prediction.pose, prediction, fitter_.schedule());
  ContourTrackStatus status = ContourTrackStatus::kTracked;
  if (fit.status == ContourFitStatus::kFitted && any(suspicious(fit))) {
    const bool better = retry(seen, body, prediction, fit);
    status = any(suspicious(fit)) ? ContourTrackStatus::kDoubtful
             : better             ? ContourTrackStatus::kRecovered
                                  : ContourTrackStatus::kTracked;
  }
  return keep(stamp_ns, fit, status);
}

}  // namespace markerless_mocap
