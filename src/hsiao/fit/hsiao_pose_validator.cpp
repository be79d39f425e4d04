#include "hsiao/fit/hsiao_pose_validator.h"

#include <cmath>
#include <limits>

#include "hsiao/fit/hull_agreement.h"

namespace markerless_mocap {
namespace {

constexpr std::array<bool, kPartCount> kAllParts = {true, true, true, true, true, true};

std::string percent(double fraction) {
  return std::to_string(std::lround(100 * fraction)) + " %";
}
std::string millimetres(double m) {
  return std::to_string(std::lround(1000 * m)) + " mm";
}

}  // namespace

HsiaoPoseValidator::HsiaoPoseValidator(const HsiaoBodyModel& body_model,
                                       const HsiaoBodyShape& shape, const HsiaoOptions& options)
    : body_model_(&body_model), shape_(&shape), options_(options) {}

std::array<double, kPartCount> HsiaoPoseValidator::partErrors(const HsiaoFrames& frames,
                                                              const HsiaoObservation& now) const {
  std::array<double, kPartCount> errors;
  errors.fill(std::numeric_limits<double>::infinity());
  const PartMatrix matrix = now.curves.matrix(frames, kAllParts);
  const PartAssignment assignment = assignParts(matrix);
  for (int data = 0; data < kPartCount; ++data)
    if (assignment[data] >= 0) errors[assignment[data]] = matrix(data, assignment[data]);
  return errors;
}

BodyPose HsiaoPoseValidator::validate(const HsiaoVector& v, const HsiaoObservation& now) const {
  HsiaoFrames frames;
  body_model_->frames(v.data(), frames);
  BodyPose pose;
  const std::array<double, kPartCount> errors = partErrors(frames, now);
  for (int part = 0; part < kPartCount; ++part)
    pose.part_seen[part] = errors[part] <= options_.max_limb_error;
  pose.skeleton_error_m = now.curves(frames, kAllParts);
  const HullAgreement agreement =
      measureHullAgreement(*shape_, frames, now.hull, now.field, options_.hull_margin);
  pose.hull_explained = agreement.hull_explained;
  pose.body_in_hull = agreement.body_in_hull;
  pose.reason = rejectionReason(pose, now.parts.part(PartLabel::kTorso).seen);
  pose.status = pose.reason.empty() ? PoseStatus::kTracked : PoseStatus::kLost;
  if (pose.reason.empty()) pose.reason = unseenParts(pose.part_seen);
  return pose;
}

std::string HsiaoPoseValidator::rejectionReason(const BodyPose& pose, bool has_torso) const {
  if (has_torso && !pose.part_seen[size_t(PartLabel::kTorso)])
    return "the torso of the best pose does not agree with the part curves";
  if (pose.skeleton_error_m > options_.max_skeleton_error)
    return "the best pose differs from the part curves by " + millimetres(pose.skeleton_error_m) +
           ", allowed is up to " + millimetres(options_.max_skeleton_error);
  if (!options_.use_hull) return "";
  if (pose.hull_explained < options_.min_hull_explained)
    return "the best pose explains " + percent(pose.hull_explained) + " of the hull, at least " +
           percent(options_.min_hull_explained) + " is needed";
  if (pose.body_in_hull < options_.min_body_in_hull)
    return "the best pose has " + percent(pose.body_in_hull) +
           " of the body in the hull, at least " + percent(options_.min_body_in_hull) +
           " is needed";
  return "";
}

}  // namespace markerless_mocap
