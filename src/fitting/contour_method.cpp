#include "fitting/contour_method.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "fitting/start_poses.h"
#include "fitting/tracked_person.h"

namespace markerless_mocap {
namespace {

// A limb is seen when contours hold its end to this, and it is not mostly outside the masks.
constexpr double kSeenDeviation = 0.06, kSeenOutside = 0.10;  // metres

// Both hypotheses of front and back are followed until the one's quality, summed over instants, is
// ahead by this.
constexpr double kDecided = 0.15;

double qualityOf(const ContourFit& fit) {
  return 0.5 * (fit.overlap + fit.rays_explained);
}

SizePrior priorOf(const TrackerSources& sources, const TrackerOptions& options) {
  return {sources.people, options.skeleton.stature, options.stature_deviation};
}

/// Whose limb a part is.
ContourLimb::Id limbOf(int part) {
  constexpr ContourLimb::Id kLimbs[kPartCount] = {ContourLimb::kTrunk,   ContourLimb::kHead,
                                                  ContourLimb::kLeftArm, ContourLimb::kRightArm,
                                                  ContourLimb::kLeftLeg, ContourLimb::kRightLeg};
  return kLimbs[part];
}

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

ContourMethod::ContourMethod(const CameraRig& rig, TrackerSources sources,
                             const TrackerOptions& options)
    : sources_(std::move(sources)),
      options_(options),
      observer_(rig, options.contour),
      tracker_(rig, options.contour) {
  takeOver(bodyBeforehand(sources_, options_.skeleton.stature));
  if (options_.measure && !body_->measured)
    measurer_.emplace(rig, options_.contour, priorOf(sources_, options_), options_.measuring_poses,
                      sources_.in_background);
}

void ContourMethod::takeOver(std::shared_ptr<const TrackedBody> body) {
  body_ = std::move(body);
  shape_.emplace(body_->sizes);
  conversion_.emplace(body_->model);
  seeker_.emplace(body_->model, options_.skeleton);
}

void ContourMethod::reset() {
  tracker_.lose();
  rival_.reset();
  seeker_->reset();
  conversion_->reset();
  stamp_.reset();
}

ContourTrack ContourMethod::follow(int64_t stamp_ns, const ContourObservation& seen) {
  ContourTrack track = tracker_.update(stamp_ns, seen, *shape_);
  if (!rival_) return track;
  const ContourTrack other = rival_->update(stamp_ns, seen, *shape_);
  const bool own = track.status != ContourTrackStatus::kLost;
  const bool others = other.status != ContourTrackStatus::kLost;
  if (own && others) rival_gain_ += qualityOf(other.fit) - qualityOf(track.fit);
  const bool replaced = others && (!own || rival_gain_ > kDecided);
  if (replaced) {
    tracker_ = *rival_;
    track = other;
  }
  if (replaced || !others || rival_gain_ < -kDecided) rival_.reset();
  return track;
}

std::vector<ContourPose> ContourMethod::proposals(const TrackingInstant& now) {
  std::vector<ContourPose> poses;
  const BodyPose pose = seeker_->update(now.stamp_ns, now.parts, now.hull);
  seeker_reason_ = pose.reason;
  if (pose.status != PoseStatus::kLost)
    poses.push_back(conversion_->poseOf(pose.T_world_body, pose.angles));
  if (const auto of_tree = poseOfTree(now.tree)) poses.push_back(*of_tree);
  if (poses.empty()) poses = uprightPoses(now.hull, *shape_);
  return poses;
}

ContourFit ContourMethod::bestFit(const ContourObservation& seen,
                                  const std::vector<ContourPose>& starts) const {
  std::vector<ContourFit> fits(starts.size());
  tbb::parallel_for(size_t(0), starts.size(), [&](size_t i) {
    fits[i] = tracker_.fitter().fit(seen, *shape_, starts[i], std::nullopt, FitSchedule::wide());
  });
  ContourFit best;
  for (const ContourFit& fit : fits)
    if (fit.status == ContourFitStatus::kFitted &&
        (best.status != ContourFitStatus::kFitted || qualityOf(fit) > qualityOf(best)))
      best = fit;
  return best;
}

ContourTrack ContourMethod::start(const TrackingInstant& now, const ContourObservation& seen) {
  if (seen.usableViews() < 2) return {};
  const ContourFit best = bestFit(seen, proposals(now));
  if (best.status != ContourFitStatus::kFitted) return {};
  const ContourTrack track = tracker_.start(now.stamp_ns, seen, *shape_, best.pose);
  if (track.status == ContourTrackStatus::kLost) return track;
  rival_.emplace(tracker_);
  rival_gain_ = 0.0;
  const ContourFit other = bestFit(seen, {mirrored(*shape_, track.fit.pose)});
  if (rival_->startFrom(now.stamp_ns, other).status == ContourTrackStatus::kLost) rival_.reset();
  return track;
}

std::optional<BodyPose> ContourMethod::measure(int64_t stamp_ns, const ContourObservation& seen,
                                               const ContourTrack& track) {
  if (!measurer_) return std::nullopt;
  if (!rival_ && track.status != ContourTrackStatus::kLost)
    measurer_->add(stamp_ns, seen, *shape_, track.fit);
  if (const std::optional<ContourSizes> sizes = measurer_->sizes()) {
    takeOver(bodyOfSizes(sources_, *sizes));
    measurer_.reset();
    return std::nullopt;
  }
  BodyPose pose;
  pose.reason = "the body is being measured, " + std::to_string(measurer_->poses()) + " of " +
                std::to_string(options_.measuring_poses) + " different poses have been seen";
  return pose;
}

void ContourMethod::measureNow() {
  if (!measurer_) return;
  measurer_->estimateNow();
  if (const std::optional<ContourSizes> sizes = measurer_->sizes()) {
    takeOver(bodyOfSizes(sources_, *sizes));
    measurer_.reset();
  }
}

BodyPose ContourMethod::lost(const ContourObservation& seen, const ContourTrack& track) const {
  BodyPose pose;
  if (seen.usableViews() < 2)
    pose.reason =
        "the person shows in " + std::to_string(seen.usableViews()) + " silhouettes, needed are 2";
  else if (track.fit.status != ContourFitStatus::kFitted)
    pose.reason = seeker_reason_;
  else
    pose.reason = "no pose covers the silhouettes, the best one's overlap is " +
                  number("%.2f", track.fit.overlap);
  return pose;
}

BodyPose ContourMethod::claimed(const ContourTrack& track, bool started) {
  BodyPose pose;
  pose.status = started ? PoseStatus::kReinitialized : PoseStatus::kTracked;
  conversion_->convert(track.fit.pose, pose.T_world_body, pose.angles);
  pose.silhouette_overlap = track.fit.overlap;
  for (int part = 0; part < kPartCount; ++part) {
    const LimbEvidence& limb = track.fit.limbs[limbOf(part)];
    pose.part_deviation_m[size_t(part)] = limb.deviation;
    pose.part_seen[size_t(part)] = limb.deviation < kSeenDeviation && limb.outside < kSeenOutside;
  }
  return pose;
}

BodyPose ContourMethod::update(const TrackingInstant& now) {
  if (stamp_ && now.stamp_ns <= *stamp_) reset();
  stamp_ = now.stamp_ns;
  const ContourObservation seen = observer_.observe(now.masks);
  ContourTrack track = follow(now.stamp_ns, seen);
  const bool started = track.status == ContourTrackStatus::kLost;
  if (started) track = start(now, seen);
  if (const std::optional<BodyPose> measuring = measure(now.stamp_ns, seen, track))
    return *measuring;
  if (track.status == ContourTrackStatus::kLost) return lost(seen, track);
  return claimed(track, started);
}

}  // namespace markerless_mocap
