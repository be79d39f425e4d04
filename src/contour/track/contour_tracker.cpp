#include "contour/contour_tracker.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "contour/track/default_postures.h"
#include "contour/track/pose_from_pose_tree.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {
namespace {

// A limb is seen when contours hold its end to this, while posture alone leaves an arm's 0.1 open,
// and it is not mostly outside the masks.
constexpr double kSeenDeviation = 0.08, kSeenOutside = 0.10;  // metres

constexpr int64_t kUnsure_ns = 2000000000;  // after a start
constexpr int64_t kBetweenQuestions_ns = 200000000;

// A start that explains the masks less is believed when one from a later instant alone leads to the
// same body. Sizes that are not this person's explain less.
constexpr double kPlain = 0.90, kPlainUnmeasured = 0.86;
// A person in a long dress covers 0.78 of the silhouettes with sizes told by one instant, a man and
// the chair he sits on 0.68: starts that cover no more than this are never believed.
constexpr double kLeastCovered = 0.72;
constexpr double kPoor = 0.80;  // other postures are tried when proposals explain less
constexpr int64_t kBetweenStarts_ns = 50000000;

ShapePrior priorOf(const PersonResources& sources, const PersonOptions& person) {
  return {sources.people, person.stature, person.stature_sigma};
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

std::string uncovered(const ContourFit& fit) {
  return "no pose covers the silhouettes, the best one's overlap is " + number("%.2f", fit.overlap);
}

}  // namespace

ContourMethod::ContourMethod(const CameraRig& rig, PersonResources sources,
                             const PersonOptions& person, const ContourOptions& options,
                             InitializerFactory make_initializer)
    : sources_(std::move(sources)),
      person_(person),
      make_initializer_(std::move(make_initializer)),
      observer_(rig, options),
      hypotheses_(rig, options) {
  takeOver(initialBody(sources_, person_.stature));
  if (person_.measure && !body_->measured)
    measurer_.emplace(rig, options, priorOf(sources_, person_), person_.shape_poses,
                      sources_.in_background);
}

void ContourMethod::takeOver(std::shared_ptr<const TrackedBody> body) {
  body_ = std::move(body);
  shape_.emplace(body_->sizes);
  conversion_.emplace(body_->model);
  initializer_ = make_initializer_(body_->model);
}

void ContourMethod::reset() {
  hypotheses_.lose();
  sure_after_ns_ = next_start_ns_ = next_reconsideration_ns_ = 0;
  initializer_->reset();
  conversion_->reset();
  stamp_.reset();
}

std::vector<ContourPose> ContourMethod::proposals(const TrackerInput& now,
                                                  const ContourObservation& seen) {
  std::vector<ContourPose> poses;
  const BodyPose pose = initializer_->update(now.stamp_ns, now.parts, now.hull);
  initializer_error_ = pose.reason;
  if (pose.status != PoseStatus::kLost)
    poses.push_back(conversion_->poseOf(pose.T_world_body, pose.angles));
  if (const auto of_tree = poseFromPoseTree(now.tree)) poses.push_back(*of_tree);
  if (qualityOf(hypotheses_.bestFit(seen, *shape_, poses)) < kPoor)
    for (const ContourPose& posture : defaultPostures(now.hull)) poses.push_back(posture);
  return poses;
}

// Measuring goes a short way only, so it begins with the stature that explains the masks best.
void ContourMethod::guessStature(const ContourObservation& seen,
                                 const std::vector<ContourPose>& poses) {
  double best_stature = person_.stature, best_quality = 0.0;
  for (const double stature : {1.5, 1.6, 1.7, 1.8, 1.9, person_.stature}) {
    const ContourBody body(sources_.people.sizes(stature));
    const double quality = qualityOf(hypotheses_.bestFit(seen, body, poses));
    if (quality <= best_quality) continue;
    best_quality = quality;
    best_stature = stature;
  }
  takeOver(initialBody(sources_, best_stature));
  measurer_->setStature(best_stature);
}

ActiveTrack ContourMethod::start(const TrackerInput& now, const ContourObservation& seen) {
  if (seen.usableViews() < 2) return {};
  const std::vector<ContourPose> poses = proposals(now, seen);
  if (measurer_ && !poses.empty()) guessStature(seen, poses);
  return hypotheses_.start(now.stamp_ns, seen, *shape_, poses);
}

ActiveTrack ContourMethod::reinitialize(const TrackerInput& now, const ContourObservation& seen,
                                        const ActiveTrack& held) {
  if (now.stamp_ns < next_start_ns_) return held;
  next_start_ns_ = now.stamp_ns + kBetweenStarts_ns;
  initializer_->reset();  // this instant alone shall tell
  return hypotheses_.reinitialize(now.stamp_ns, seen, *shape_, proposals(now, seen), held);
}

bool ContourMethod::isDecided(const ContourFit& fit) const {
  const bool plain = qualityOf(fit) > (measurer_ ? kPlainUnmeasured : kPlain);
  return fit.overlap > kLeastCovered && hypotheses_.isUnambiguous() &&
         (plain || hypotheses_.isConfirmed());
}

// A valid tree is nearly always right, so one that contradicts the pose is heard; while the pose is
// not sure, other trees and other sides are, too.
void ContourMethod::reconsider(const TrackerInput& now, const ContourObservation& seen,
                               const ContourTrackingResult& track) {
  const bool started = now.stamp_ns < sure_after_ns_;
  const bool unsure = started || track.status == ContourTrackingStatus::kLimbLost;
  if (now.stamp_ns < next_reconsideration_ns_ || hypotheses_.hasAlternative()) return;
  std::vector<ContourPose> others;
  const auto of_tree = poseFromPoseTree(now.tree);
  if (of_tree && (now.tree.valid() || unsure) && limbsDiffer(*shape_, track.fit.pose, *of_tree))
    others.push_back(*of_tree);
  if (started) {
    others.push_back(mirrored(*shape_, track.fit.pose));
    others.push_back(withLegsSwapped(*shape_, track.fit.pose));
  }
  if (others.empty()) return;
  next_reconsideration_ns_ = now.stamp_ns + kBetweenQuestions_ns;
  hypotheses_.proposeAlternative(now.stamp_ns, seen, *shape_, others);
}

std::optional<BodyPose> ContourMethod::measure(int64_t stamp_ns, const ContourObservation& seen,
                                               const ContourFit& fit) {
  if (!measurer_) return std::nullopt;
  BodyPose pose;
  if (decided_ && hypotheses_.isUnambiguous()) measurer_->add(stamp_ns, seen, *shape_, fit);
  if (takeOverMeasured()) {
    pose.reason = "the body has just been measured";  // the pose is another body's
    return pose;
  }
  pose.reason = "the body is being measured, " + std::to_string(measurer_->poses()) + " of " +
                std::to_string(person_.shape_poses) + " different poses have been seen";
  return pose;
}

void ContourMethod::estimateShapeNow() {
  if (!measurer_) return;
  measurer_->estimateNow();
  takeOverMeasured();
}

bool ContourMethod::takeOverMeasured() {
  const std::optional<ShapeParameters> sizes = measurer_->sizes();
  if (!sizes) return false;
  takeOver(bodyFromShape(sources_, *sizes));
  measurer_.reset();
  return true;
}

BodyPose ContourMethod::lost(const ContourObservation& seen,
                             const ContourTrackingResult& track) const {
  BodyPose pose;
  if (seen.usableViews() < 2)
    pose.reason =
        "the person shows in " + std::to_string(seen.usableViews()) + " silhouettes, needed are 2";
  else if (track.fit.status != ContourFitStatus::kFitted)
    pose.reason =
        initializer_error_.empty() ? "no pose covers the silhouettes" : initializer_error_;
  else
    pose.reason = uncovered(track.fit);
  return pose;
}

BodyPose ContourMethod::undecided(const ContourFit& fit) const {
  BodyPose pose;
  if (fit.overlap <= kLeastCovered)
    pose.reason = uncovered(fit);
  else if (hypotheses_.isUnambiguous())
    pose.reason = "the person is found, but in one instant only";
  else
    pose.reason = "the person is found, front and back are not told apart yet";
  return pose;
}

BodyPose ContourMethod::reported(const ActiveTrack& held) {
  BodyPose pose;
  pose.status = held.switched || !reported_ ? PoseStatus::kReinitialized : PoseStatus::kTracked;
  reported_ = true;
  conversion_->convert(held.track.fit.pose, pose.T_world_body, pose.angles);
  pose.silhouette_overlap = held.track.fit.overlap;
  for (int part = 0; part < kPartCount; ++part) {
    const LimbEvidence& limb = held.track.fit.limbs[limbOf(part)];
    pose.part_sigma_m[size_t(part)] = limb.deviation;
    pose.part_seen[size_t(part)] = limb.deviation < kSeenDeviation && limb.outside < kSeenOutside;
  }
  return pose;
}

BodyPose ContourMethod::update(const TrackerInput& now) {
  if (stamp_ && now.stamp_ns <= *stamp_) reset();
  stamp_ = now.stamp_ns;
  const ContourObservation seen = observer_.observe(now.masks);
  ActiveTrack held = hypotheses_.update(now.stamp_ns, seen, *shape_);
  if (held.track.status == ContourTrackingStatus::kLost) {
    held = start(now, seen);
    decided_ = isDecided(held.track.fit);
    next_start_ns_ = now.stamp_ns + kBetweenStarts_ns;
    reported_ = false;
  } else {
    if (!decided_) held = reinitialize(now, seen, held);
    decided_ = decided_ || isDecided(held.track.fit);
    reconsider(now, seen, held.track);
  }
  if (held.switched) sure_after_ns_ = now.stamp_ns + kUnsure_ns;
  if (held.track.status == ContourTrackingStatus::kLost) return lost(seen, held.track);
  if (const std::optional<BodyPose> measuring = measure(now.stamp_ns, seen, held.track.fit))
    return *measuring;
  return decided_ ? reported(held) : undecided(held.track.fit);
}

}  // namespace markerless_mocap
