#include "fitting/sppso_method.h"

#include <array>
#include <stdexcept>

#include "fitting/tracked_person.h"

namespace markerless_mocap {
namespace {

// A part is seen when the silhouettes show this share of it apart from the rest of the body, and
// have this share of what sticks out.
constexpr double kLeastAlone = 0.05, kLeastInside = 0.5;

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

SppsoMethod::SppsoMethod(const CameraRig& rig, const TrackerSources& sources,
                         const TrackerOptions& options)
    : with_edges_(options.sppso.edges),
      body_(bodyBeforehand(sources, options.skeleton.stature)),
      conversion_(body_->model),
      tracker_(trackerOf(rig, *body_, sources.motion, options.sppso)),
      seeker_(body_->model, options.skeleton) {}

void SppsoMethod::reset() {
  conversion_ = FleischmannConversion(body_->model);
  tracker_.reset();
  seeker_.reset();
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

BodyPose SppsoMethod::start(const TrackingInstant& now, const std::vector<AppearanceView>& views) {
  const BodyPose proposed = seeker_.update(now.stamp_ns, now.parts, now.hull);
  std::string obstacle = proposed.reason;
  if (proposed.status != PoseStatus::kLost) {
    const SppsoPose found = tracker_.startNear(
        now.stamp_ns, conversion_.parametersOf(proposed.T_world_body, proposed.angles), views);
    if (found.status == PoseStatus::kTracked) return claimed(found, PoseStatus::kReinitialized);
    obstacle = found.reason;
  }
  BodyPose lost;
  lost.reason = "no pose to start from: " + obstacle;
  return lost;
}

BodyPose SppsoMethod::update(const TrackingInstant& now) {
  const std::vector<AppearanceView> views = viewsOf(now);
  if (stamp_ && now.stamp_ns <= *stamp_) reset();
  stamp_ = now.stamp_ns;
  const SppsoPose found = tracker_.update(now.stamp_ns, views);
  if (found.status == PoseStatus::kTracked) return claimed(found, PoseStatus::kTracked);
  return start(now, views);
}

}  // namespace markerless_mocap
