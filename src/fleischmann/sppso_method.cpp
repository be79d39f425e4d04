#include "fleischmann/sppso_method.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "tracking/tracked_person.h"

namespace markerless_mocap {
namespace {

// A part is seen when the silhouettes show this share of it apart from the rest of the body, and
// have this share of what sticks out.
constexpr double kLeastAlone = 0.05, kLeastInside = 0.5;

// A pose is questioned when its silhouette fitness falls behind the best of late by this, and given
// up for one whose whole fitness is clearly better.
constexpr double kDoubt = 0.03, kClearlyBetter = 0.02;
constexpr double kForgetting = 0.9995;  // of the best, per instant
constexpr int64_t kBetweenQuestions_ns = 400000000;

/// By PartLabel.
constexpr std::array<ConeSet, kPartCount> kPartCones = {
    coneBit(kTorsoCone),
    coneBit(kHeadCone),
    coneBit(kLeftUpperArmCone) | coneBit(kLeftLowerArmCone),
    coneBit(kRightUpperArmCone) | coneBit(kRightLowerArmCone),
    coneBit(kLeftThighCone) | coneBit(kLeftCalfCone),
    coneBit(kRightThighCone) | coneBit(kRightCalfCone)};

bool isSeen(const ConeEvidence& part) {
  return double(part.alone) > kLeastAlone * double(part.drawn) &&
         double(part.inside) > kLeastInside * double(part.alone);
}

const MotionStatistics& requireMotion(const MotionStatistics& motion) {
  if (motion.largest_change.isZero())
    throw std::invalid_argument(
        "pose_fitting/method is sppso, which needs motion statistics in which something moves");
  return motion;
}

SppsoTracker trackerOf(const CameraRig& rig, const TrackedBody& body,
                       const MotionStatistics& motion, const SppsoOptions& options) {
  const FleischmannProfile profile(*body.model);
  return SppsoTracker(rig, profile, ConeBody(*body.model, profile), requireMotion(motion), options);
}

}  // namespace

SppsoMethod::SppsoMethod(const CameraRig& rig, const PersonSources& sources,
                         const PersonOptions& person, const SppsoOptions& options,
                         const MotionStatistics& motion,
                         const InitializerFactory& make_initializer)
    : with_edges_(options.edges),
      body_(bodyBeforehand(sources, person.stature)),
      conversion_(body_->model),
      tracker_(trackerOf(rig, *body_, motion, options)),
      seeker_(make_initializer(body_->model)) {}

void SppsoMethod::reset() {
  conversion_ = FleischmannConversion(body_->model);
  tracker_.reset();
  seeker_->reset();
  stamp_.reset();
}

std::vector<AppearanceView> SppsoMethod::viewsOf(const TrackingInstant& now) const {
  if (now.images.size() != now.masks.size())
    throw std::invalid_argument(std::to_string(now.images.size()) + " images came with " +
                                std::to_string(now.masks.size()) + " masks");
  std::vector<AppearanceView> views(now.masks.size());
  for (size_t i = 0; i < views.size(); ++i) {
    views[i].silhouette = now.masks[i];
    if (with_edges_) views[i].image = now.images[i];
  }
  return views;
}

BodyPose SppsoMethod::claimed(const SppsoPose& found, PoseStatus status) {
  BodyPose pose;
  pose.status = status;
  conversion_.convert(found.v, pose.T_world_body, pose.angles);
  pose.silhouette_overlap = found.fitness.silhouette;
  for (size_t part = 0; part < kPartCones.size(); ++part)
    pose.part_seen[part] = isSeen(tracker_.fitness().evidence(found.v.data(), kPartCones[part]));
  return pose;
}

SppsoPose SppsoMethod::proposed(const TrackingInstant& now,
                                const std::vector<AppearanceView>& views, double better_than) {
  seeker_->reset();
  const BodyPose seen = seeker_->update(now.stamp_ns, now.parts, now.hull);
  if (seen.status == PoseStatus::kLost) {
    SppsoPose none;
    none.reason = seen.reason;
    return none;
  }
  FleischmannConversion conversion = conversion_;  // what is not claimed leaves no trace
  return tracker_.startNear(now.stamp_ns, conversion.parametersOf(seen.T_world_body, seen.angles),
                            views, better_than);
}

BodyPose SppsoMethod::start(const TrackingInstant& now, const std::vector<AppearanceView>& views) {
  const SppsoPose found = proposed(now, views, 0.0);
  if (found.status == PoseStatus::kTracked) {
    usual_ = found.fitness.silhouette;
    next_question_ns_ = now.stamp_ns + kBetweenQuestions_ns;
    return claimed(found, PoseStatus::kReinitialized);
  }
  BodyPose lost;
  lost.reason = "no pose to start from: " + found.reason;
  return lost;
}

std::optional<SppsoPose> SppsoMethod::question(const TrackingInstant& now,
                                               const std::vector<AppearanceView>& views,
                                               const SppsoPose& found) {
  usual_ = std::max(kForgetting * usual_, found.fitness.silhouette);
  if (now.stamp_ns < next_question_ns_ || found.fitness.silhouette > usual_ - kDoubt)
    return std::nullopt;
  next_question_ns_ = now.stamp_ns + kBetweenQuestions_ns;
  const SppsoPose other = proposed(now, views, found.fitness.total() + kClearlyBetter);
  if (other.status != PoseStatus::kTracked) return std::nullopt;
  return other;
}

BodyPose SppsoMethod::update(const TrackingInstant& now) {
  const std::vector<AppearanceView> views = viewsOf(now);
  if (stamp_ && now.stamp_ns <= *stamp_) reset();
  stamp_ = now.stamp_ns;
  const SppsoPose found = tracker_.update(now.stamp_ns, views);
  if (found.status != PoseStatus::kTracked) return start(now, views);
  if (const std::optional<SppsoPose> other = question(now, views, found))
    return claimed(*other, PoseStatus::kReinitialized);
  return claimed(found, PoseStatus::kTracked);
}

}  // namespace markerless_mocap
