#include "hsiao/fit/hsiao_pose_search.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kMinStep = 1.0 / 60.0, kMaxStep = 0.2;  // seconds

// Range of an unseen arm around its last seen angles, radians: the hull constrains the shoulder
// weakly and the elbow hardly at all.
constexpr double kUnseenShoulderRange = 0.4;
constexpr double kUnseenElbowRange = 0.3;

HsiaoVector hangingArms() {
  HsiaoVector v = HsiaoVector::Zero();
  v[hsiaoTheta(3)] = -M_PI / 2;
  v[hsiaoTheta(4)] = M_PI / 2;
  return v;
}

HsiaoFitterSettings fitterSettings(const HsiaoOptions& o) {
  HsiaoFitterSettings s;
  s.limits = o.joint_limits;
  s.particles_per_parameter = o.particles_per_parameter;
  s.iterations_per_parameter = o.iterations_per_parameter;
  s.fine_tune_particles = o.fine_tune_particles;
  s.fine_tune_iterations = o.fine_tune_iterations;
  s.initial_headings = o.initial_headings;
  s.as_published = o.search == "published";
  s.inertia = o.inertia;
  s.cognitive_weight = o.cognitive_weight;
  s.social_weight = o.social_weight;
  return s;
}

HsiaoRefinerSettings refinerSettings(const HsiaoOptions& o) {
  HsiaoRefinerSettings s;
  s.iterations = o.refinement_iterations;
  s.refinement_surface_points = o.refinement_surface_points;
  return s;
}

// If a leg is missing, an arm may be mistaken for it, and only the last pose could tell.
bool canStartFrom(const std::array<bool, kPartCount>& seen) {
  return seen[size_t(PartLabel::kTorso)] && seen[size_t(PartLabel::kHead)] &&
         seen[size_t(PartLabel::kLeg1)] && seen[size_t(PartLabel::kLeg2)];
}

Eigen::Vector3d facing(const HsiaoBodyModel& body_model, const HsiaoVector& v) {
  HsiaoFrames frames;
  body_model.frames(v.data(), frames);
  return frames.R[kTorsoSegment].col(0);
}

}  // namespace

HsiaoPoseSearch::HsiaoPoseSearch(const BodyModel& model,
                                 std::shared_ptr<const HsiaoBodyModel> body_model,
                                 const HsiaoOptions& options)
    : options_(options),
      body_model_(std::move(body_model)),
      shape_(model, *body_model_),
      fitter_(*body_model_, fitterSettings(options)),
      refiner_(*body_model_, shape_, refinerSettings(options)),
      validator_(*body_model_, shape_, options),
      arms_seen_(hangingArms()) {}

void HsiaoPoseSearch::forgetArms() {
  arms_seen_ = hangingArms();
}

HsiaoRefinement HsiaoPoseSearch::refine(const HsiaoObservation& now, const HsiaoFit& fit) const {
  if (!options_.use_hull) return {fit.v, fit.error_m};
  const HsiaoVector& v = fit.v;
  HsiaoBounds range = fitter_.limits();
  HsiaoFrames frames;
  body_model_->frames(v.data(), frames);
  const std::array<double, kPartCount> errors = validator_.partErrors(frames, now);
  for (int side = 0; side < 2; ++side) {
    if (std::isfinite(errors[size_t(PartLabel::kArm1) + side])) continue;
    for (const int k : {3, 5, 7, 9}) {
      const int p = hsiaoTheta(k + side);
      const double reach = k == 9 ? kUnseenElbowRange : kUnseenShoulderRange;
      range.lower[p] = std::max(range.lower[p], arms_seen_[p] - reach);
      range.upper[p] = std::min(range.upper[p], arms_seen_[p] + reach);
    }
  }
  const HsiaoVector start = v.cwiseMax(range.lower).cwiseMin(range.upper);
  return refiner_.refine(start, range, {&now.curves, &now.parts, &now.hull, &now.field});
}

void HsiaoPoseSearch::storeSeenArms(const HsiaoVector& v,
                                    const std::array<bool, kPartCount>& seen) {
  for (int side = 0; side < 2; ++side)
    if (seen[size_t(PartLabel::kArm1) + side])
      for (const int k : {3, 5, 7, 9}) arms_seen_[hsiaoTheta(k + side)] = v[hsiaoTheta(k + side)];
}

// As published, a basic search knows the current frame only.
HsiaoVector HsiaoPoseSearch::restOf(const std::optional<HsiaoVector>& last) const {
  return last && options_.search != "published" ? *last : hangingArms();
}

HsiaoRefinement HsiaoPoseSearch::fitBasic(const HsiaoObservation& now,
                                          const std::optional<HsiaoVector>& last,
                                          int attempts) const {
  std::optional<HsiaoRefinement> best;
  const HsiaoVector rest = restOf(last);
  for (int attempt = 0; attempt < attempts; ++attempt)
    for (const HsiaoFit& fit :
         fitter_.fitBasic(now.curves, rest, seed() + uint64_t(7919) * attempt)) {
      const HsiaoRefinement refined = refine(now, fit);
      if (!best || refined.cost < best->cost) best = refined;
    }
  return *best;
}

HsiaoFit HsiaoPoseSearch::fitBasicOnce(const HsiaoObservation& now, const HsiaoVector& last) const {
  return fitter_.fitBasic(now.curves, restOf(last), seed()).front();
}

HsiaoFit HsiaoPoseSearch::fitTemporal(const HsiaoObservation& now, const HsiaoVector& last,
                                      const std::optional<HsiaoVector>& before,
                                      double seconds) const {
  const double step = std::clamp(seconds, kMinStep, kMaxStep);
  HsiaoVector reach = HsiaoVector::Constant(options_.max_joint_velocity * step);
  reach.segment<6>(kHsiaoCenter).setConstant(options_.max_root_speed * step);
  std::vector<HsiaoVector> guesses;
  if (before) guesses.push_back(2.0 * last - *before);
  return fitter_.fitTemporal(now.curves, last, reach, guesses, seed());
}

bool HsiaoPoseSearch::areOpposite(const HsiaoVector& a, const HsiaoVector& b) const {
  return facing(*body_model_, a).dot(facing(*body_model_, b)) < 0.0;
}

BodyPose HsiaoPoseSearch::validateStart(const HsiaoObservation& now, const HsiaoVector& v) const {
  BodyPose pose = validator_.validate(v, now);
  if (pose.status == PoseStatus::kLost) return pose;
  pose.status = PoseStatus::kReinitialized;
  if (options_.use_hull && !canStartFrom(pose.part_seen)) {
    pose.status = PoseStatus::kLost;
    pose.reason = "torso, head and both legs must be seen at the start; " + pose.reason;
  }
  return pose;
}

}  // namespace markerless_mocap
