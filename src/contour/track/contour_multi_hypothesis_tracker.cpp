#include "contour/track/contour_multi_hypothesis_tracker.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "contour/track/exchanged_sides.h"

namespace markerless_mocap {
namespace {

// A hypothesis is dropped if the summed quality of the other one is better by kDecisionGain.
constexpr double kDecisionGain = 0.15;
constexpr double kUnambiguousGain = 0.05;
constexpr double kClearGain = 0.03;  // in one frame

// If there are many poses, a coarse fit selects those that are fitted to the end.
constexpr size_t kMaxFinalFits = 4;
constexpr RobustSchedule kCoarseFit{6, 0.3, 0.1};

constexpr double kMaxLimbDistance = 0.15;  // metres, of a limb's end
constexpr double kMaxBodyDistance = 0.08;  // metres, mean over the joints; one arm may differ

bool isLost(const ContourTrackingResult& track) {
  return track.status == ContourTrackingStatus::kLost;
}

}  // namespace

ContourMultiHypothesisTracker::ContourMultiHypothesisTracker(const CameraRig& rig,
                                                             const ContourOptions& options)
    : active_(rig, options) {}

bool ContourMultiHypothesisTracker::isUnambiguous() const {
  return active_.tracking() && (!alternative_ || alternative_gain_ < -kUnambiguousGain);
}

void ContourMultiHypothesisTracker::lose() {
  active_.lose();
  alternative_.reset();
  confirmed_ = false;
}

void ContourMultiHypothesisTracker::turnBack() {
  active_.turnBack();
  alternative_.reset();
}

std::vector<ContourFit> ContourMultiHypothesisTracker::fitsFrom(
    const ContourObservation& seen, const ContourBody& body, const std::vector<ContourPose>& poses,
    const RobustSchedule& schedule) const {
  std::vector<ContourFit> fits(poses.size());
  tbb::parallel_for(size_t(0), poses.size(), [&](size_t i) {
    fits[i] = active_.fitter().fit(seen, body, poses[i], std::nullopt, schedule);
  });
  const auto failed = [](const ContourFit& fit) { return fit.status != ContourFitStatus::kFitted; };
  fits.erase(std::remove_if(fits.begin(), fits.end(), failed), fits.end());
  std::stable_sort(fits.begin(), fits.end(), [](const ContourFit& one, const ContourFit& other) {
    return qualityOf(one) > qualityOf(other);
  });
  return fits;
}

std::vector<ContourFit> ContourMultiHypothesisTracker::bestFits(
    const ContourObservation& seen, const ContourBody& body, std::vector<ContourPose> poses,
    const RobustSchedule& schedule) const {
  if (poses.size() > kMaxFinalFits) {
    const std::vector<ContourFit> first = fitsFrom(seen, body, poses, kCoarseFit);
    poses.clear();
    for (size_t i = 0; i < std::min(kMaxFinalFits, first.size()); ++i)
      poses.push_back(first[i].pose);
  }
  return fitsFrom(seen, body, poses, schedule);
}

ContourFit ContourMultiHypothesisTracker::bestFit(const ContourObservation& seen,
                                                  const ContourBody& body,
                                                  std::vector<ContourPose> poses,
                                                  const RobustSchedule& schedule) const {
  const std::vector<ContourFit> fits = bestFits(seen, body, std::move(poses), schedule);
  return fits.empty() ? ContourFit{} : fits.front();
}

void ContourMultiHypothesisTracker::setAlternative(int64_t stamp_ns, const ContourFit& fit) {
  alternative_.emplace(active_);
  alternative_gain_ = 0.0;
  if (isLost(alternative_->startFrom(stamp_ns, fit))) alternative_.reset();
}

ActiveTrack ContourMultiHypothesisTracker::start(int64_t stamp_ns, const ContourObservation& seen,
                                                 const ContourBody& body,
                                                 const std::vector<ContourPose>& poses) {
  lose();
  const ContourFit best = bestFit(seen, body, poses);
  if (best.status != ContourFitStatus::kFitted) return {};
  ActiveTrack active{active_.start(stamp_ns, seen, body, best.pose), true};
  if (isLost(active.track)) return active;
  const ContourFit other = bestFit(seen, body, {mirrored(body, active.track.fit.pose)});
  if (qualityOf(other) > qualityOf(active.track.fit) - kClearGain) setAlternative(stamp_ns, other);
  return active;
}

ActiveTrack ContourMultiHypothesisTracker::startFrom(int64_t stamp_ns, const ContourFit& fit) {
  lose();
  return {active_.startFrom(stamp_ns, fit), true};
}

ActiveTrack ContourMultiHypothesisTracker::update(int64_t stamp_ns, const ContourObservation& seen,
                                                  const ContourBody& body,
                                                  const MaySearch& may_search) {
  ActiveTrack active{active_.update(stamp_ns, seen, body, may_search), false};
  if (!alternative_) return active;
  const ContourTrackingResult other = alternative_->update(stamp_ns, seen, body, may_search);
  const bool both = !isLost(active.track) && !isLost(other);
  if (both) alternative_gain_ += qualityOf(other.fit) - qualityOf(active.track.fit);
  active.switched = !isLost(other) && (isLost(active.track) || alternative_gain_ > kDecisionGain);
  if (active.switched) {
    active.track = other;
    active_ = *alternative_;
    confirmed_ = false;
  }
  // Two hypotheses often converge to the same pose.
  const bool same = both && !limbsDiffer(body, active.track.fit.pose, other.fit.pose);
  if (active.switched || isLost(other) || same || alternative_gain_ < -kDecisionGain)
    alternative_.reset();
  return active;
}

std::optional<ContourFit> ContourMultiHypothesisTracker::improve(const ContourObservation& seen,
                                                                 const ContourBody& body) {
  if (alternative_) alternative_->improve(seen, body);
  return active_.improve(seen, body);
}

ActiveTrack ContourMultiHypothesisTracker::reinitialize(int64_t stamp_ns,
                                                        const ContourObservation& seen,
                                                        const ContourBody& body,
                                                        const std::vector<ContourPose>& poses,
                                                        const ActiveTrack& active) {
  ContourMultiHypothesisTracker fresh = *this;
  const ActiveTrack other = fresh.start(stamp_ns, seen, body, poses);
  if (isLost(other.track)) return active;
  const double gain = qualityOf(other.track.fit) - qualityOf(active.track.fit);
  const bool same = isSameBody(body, active.track.fit.pose, other.track.fit.pose);
  const bool confirmed = same || (confirmed_ && gain < kClearGain);
  ActiveTrack now = active;
  now.agreed = !limbsDiffer(body, active.track.fit.pose, other.track.fit.pose);
  if (gain >= kClearGain) {
    *this = fresh;
    now = {other.track, !same};
  }
  confirmed_ = confirmed;
  return now;
}

void ContourMultiHypothesisTracker::proposeAlternative(int64_t stamp_ns,
                                                       const ContourObservation& seen,
                                                       const ContourBody& body,
                                                       const std::vector<ContourPose>& poses) {
  if (alternative_ || !active_.tracking()) return;
  const ContourFit best = bestFit(seen, body, poses);
  if (best.status == ContourFitStatus::kFitted &&
      qualityOf(best) > active_.quality() - kClearGain &&
      limbsDiffer(body, best.pose, active_.pose()))
    setAlternative(stamp_ns, best);
}

bool isSameBody(const ContourBody& body, const ContourPose& pose, const ContourPose& other) {
  return (body.points(pose) - body.points(other)).colwise().norm().mean() < kMaxBodyDistance;
}

bool limbsDiffer(const ContourBody& body, const ContourPose& pose, const ContourPose& other) {
  const Eigen::Matrix3Xd points = body.points(pose), others = body.points(other);
  for (const auto limb : {ContourLimb::kLeftArm, ContourLimb::kRightArm, ContourLimb::kLeftLeg,
                          ContourLimb::kRightLeg}) {
    const Eigen::Index end = Eigen::Index(endOfLimb(limb));
    if ((points.col(end) - others.col(end)).norm() > kMaxLimbDistance) return true;
  }
  return false;
}

}  // namespace markerless_mocap
