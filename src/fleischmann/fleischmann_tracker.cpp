#include "fleischmann/fleischmann_tracker.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {
namespace {

// A part is seen if at least the first fraction of it is visible apart from the rest of the body,
// and at least the second fraction of that is in the silhouettes.
constexpr double kMinAlone = 0.05, kMinInside = 0.5;

// The pose is reconsidered if its silhouette fitness is lower than its recent maximum by kMaxDrop.
// It is replaced if the total fitness of another pose is better by kMinGain.
constexpr double kMaxDrop = 0.03, kMinGain = 0.02;
constexpr double kMaximumDecay = 0.9995;  // of the maximum, per frame
constexpr int64_t kReconsiderInterval_ns = 400000000;

/// Indexed by PartLabel.
constexpr std::array<ConeSet, kPartCount> kPartCones = {
    coneBit(kTorsoCone),
    coneBit(kHeadCone),
    coneBit(kLeftUpperArmCone) | coneBit(kLeftLowerArmCone),
    coneBit(kRightUpperArmCone) | coneBit(kRightLowerArmCone),
    coneBit(kLeftThighCone) | coneBit(kLeftCalfCone),
    coneBit(kRightThighCone) | coneBit(kRightCalfCone)};

bool isSeen(const ConeVisibility& part) {
  return double(part.alone) > kMinAlone * double(part.drawn) &&
         double(part.inside) > kMinInside * double(part.alone);
}

const FleischmannMotionStatistics& requireMotion(const FleischmannMotionStatistics& motion) {
  if (motion.max_change.isZero())
    throw std::invalid_argument(
        "pose_fitting/method is fleischmann, which needs motion statistics that are not all "
        "zero");
  return motion;
}

FleischmannPoseEstimator trackerOf(const CameraRig& rig, const TrackedBody& body,
                                   const FleischmannMotionStatistics& motion,
                                   const FleischmannOptions& options) {
  const FleischmannBodyModel body_model(*body.model);
  return FleischmannPoseEstimator(rig, body_model,
                                  FleischmannBodyShape(*body.model, body_model, options.body),
                                  requireMotion(motion), options);
}

}  // namespace

FleischmannTracker::FleischmannTracker(const CameraRig& rig, const PersonResources& resources,
                                       const PersonOptions& person,
                                       const FleischmannOptions& options,
                                       const FleischmannMotionStatistics& motion,
                                       const InitializerFactory& make_initializer)
    : with_edges_(options.use_edges),
      reconsiders_(options.reconsider),
      body_(initialBody(resources, person.stature)),
      conversion_(body_->model),
      tracker_(trackerOf(rig, *body_, motion, options)),
      initializer_(make_initializer(body_->model)) {}

void FleischmannTracker::reset() {
  conversion_ = FleischmannUrdfConverter(body_->model);
  tracker_.reset();
  initializer_->reset();
  stamp_.reset();
}

std::vector<FleischmannView> FleischmannTracker::viewsOf(const TrackerInput& now) const {
  if (now.images.size() != now.masks.size())
    throw std::invalid_argument(std::to_string(now.images.size()) + " images were given with " +
                                std::to_string(now.masks.size()) + " masks");
  std::vector<FleischmannView> views(now.masks.size());
  for (size_t i = 0; i < views.size(); ++i) {
    views[i].silhouette = now.masks[i];
    if (with_edges_) views[i].image = now.images[i];
  }
  return views;
}

BodyPose FleischmannTracker::reported(const FleischmannEstimate& found, PoseStatus status) {
  BodyPose pose;
  pose.status = status;
  conversion_.convert(found.v, pose.T_world_body, pose.angles);
  pose.silhouette_overlap = found.fitness.silhouette;
  for (size_t part = 0; part < kPartCones.size(); ++part)
    pose.part_seen[part] = isSeen(tracker_.fitness().evidence(found.v.data(), kPartCones[part]));
  pose.reason = unseenParts(pose.part_seen);
  return pose;
}

FleischmannEstimate FleischmannTracker::proposed(const TrackerInput& now,
                                                 const std::vector<FleischmannView>& views,
                                                 double better_than) {
  initializer_->reset();
  const FrameProducts& made = now.products.ofThisFrame();
  const BodyPose seen = initializer_->update(now.stamp_ns, made.parts, made.hull);
  if (seen.status == PoseStatus::kLost) {
    FleischmannEstimate none;
    none.reason = seen.reason;
    return none;
  }
  FleischmannUrdfConverter conversion = conversion_;  // a copy, because the proposal may be
                                                      // rejected
  return tracker_.reinitializeNear(
      now.stamp_ns, conversion.parametersOf(seen.T_world_body, seen.angles), views, better_than);
}

BodyPose FleischmannTracker::start(const TrackerInput& now,
                                   const std::vector<FleischmannView>& views) {
  const FleischmannEstimate found = proposed(now, views, 0.0);
  if (found.status == PoseStatus::kTracked) {
    usual_ = found.fitness.silhouette;
    next_reconsideration_ns_ = now.stamp_ns + kReconsiderInterval_ns;
    return reported(found, PoseStatus::kReinitialized);
  }
  BodyPose lost;
  lost.reason = "no start pose: " + found.reason;
  return lost;
}

std::optional<FleischmannEstimate> FleischmannTracker::reconsider(
    const TrackerInput& now, const std::vector<FleischmannView>& views,
    const FleischmannEstimate& found) {
  usual_ = std::max(kMaximumDecay * usual_, found.fitness.silhouette);
  if (now.stamp_ns < next_reconsideration_ns_ || found.fitness.silhouette > usual_ - kMaxDrop)
    return std::nullopt;
  next_reconsideration_ns_ = now.stamp_ns + kReconsiderInterval_ns;
  const FleischmannEstimate other = proposed(now, views, found.fitness.total() + kMinGain);
  if (other.status != PoseStatus::kTracked) return std::nullopt;
  return other;
}

BodyPose FleischmannTracker::update(const TrackerInput& now) {
  const std::vector<FleischmannView> views = viewsOf(now);
  if (stamp_ && now.stamp_ns <= *stamp_) reset();
  stamp_ = now.stamp_ns;
  const FleischmannEstimate found = tracker_.update(now.stamp_ns, views);
  if (found.status != PoseStatus::kTracked) return start(now, views);
  std::optional<FleischmannEstimate> other;
  if (reconsiders_) other = reconsider(now, views, found);
  if (other) return reported(*other, PoseStatus::kReinitialized);
  return reported(found, PoseStatus::kTracked);
}

}  // namespace markerless_mocap
