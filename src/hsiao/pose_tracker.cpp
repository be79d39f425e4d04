#include "hsiao/pose_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "hsiao/fit/hierarchical_fitter.h"
#include "hsiao/model/hsiao_conversion.h"
#include "hsiao/fit/pose_judge.h"
#include "hsiao/fit/pose_refiner.h"

namespace markerless_mocap {
namespace {

constexpr double kShortestStep = 1.0 / 60.0, kLongestStep = 0.2;  // seconds
// A turn about is believed when its advantage, a share of the cost summed over frames, exceeds
// this; the sum fades by kEvidenceFade a frame.
constexpr double kTurnEvidence = 0.6;
constexpr double kEvidenceFade = 0.8;
// A body seen again must fit this much better to replace the one that is followed.
constexpr double kReplaceShare = 0.95;

// What an unseen arm may be moved from where it was last seen, radians: the hull still tells a
// little of the shoulder, nothing of the elbow.
constexpr double kUnseenShoulderReach = 0.4;
constexpr double kUnseenElbowReach = 0.3;

// A pose that the hull alone carries on must agree with it nearly as well as the last one with
// parts.
constexpr double kCarriedShare = 0.93;

HsiaoVector hangingArms() {
  HsiaoVector v = HsiaoVector::Zero();
  v[hsiaoTheta(3)] = -M_PI / 2;
  v[hsiaoTheta(4)] = M_PI / 2;
  return v;
}

FitterSettings fitterSettings(const FittingOptions& o) {
  FitterSettings s;
  s.limits = o.limits;
  s.particles_per_parameter = o.particles_per_parameter;
  s.iterations_per_parameter = o.iterations_per_parameter;
  s.tune_particles = o.tune_particles;
  s.tune_iterations = o.tune_iterations;
  s.spin_starts = o.spin_starts;
  return s;
}

RefinerSettings refinerSettings(const FittingOptions& o) {
  RefinerSettings s;
  s.iterations = o.refine_iterations;
  s.surface_points = o.surface_points;
  return s;
}

// Why there is nothing to fit to; empty if there is.
std::string hullObstacle(const VisualHull& hull) {
  if (hull.status == HullStatus::kOk && !hull.voxels.empty()) return "";
  return hull.reason.empty() ? "there is no hull" : hull.reason;
}

std::string partsObstacle(const BodyParts& parts) {
  if (parts.status == SegmentationStatus::kInvalid)
    return parts.reason.empty() ? "the hull has no parts" : parts.reason;
  if (!parts.part(PartLabel::kTorso).seen) return "the torso is not seen";
  return "";
}

// Legs that pass each other touch, and their curves may change sides there.
bool areLegsMerged(const BodyParts& parts) {
  const PartCurve& one = parts.part(PartLabel::kLeg1);
  const PartCurve& other = parts.part(PartLabel::kLeg2);
  return (one.seen && !one.whole) || (other.seen && !other.whole);
}

// With a leg missing an arm may pass for one, and nothing but the last pose tells.
bool canStartFrom(const std::array<bool, kPartCount>& seen) {
  return seen[size_t(PartLabel::kTorso)] && seen[size_t(PartLabel::kHead)] &&
         seen[size_t(PartLabel::kLeg1)] && seen[size_t(PartLabel::kLeg2)];
}

Eigen::Vector3d facing(const HsiaoProfile& profile, const HsiaoVector& v) {
  HsiaoFrames frames;
  profile.frames(v.data(), frames);
  return frames.R[kTorsoSegment].col(0);
}

}  // namespace

struct PoseTracker::State {
  State(std::shared_ptr<const BodyModel> the_model, const FittingOptions& the_options)
      : options(the_options),
        model(std::move(the_model)),
        profile(std::make_shared<HsiaoProfile>(*model)),
        shape(*model, *profile),
        fitter(*profile, fitterSettings(options)),
        refiner(*profile, shape, refinerSettings(options)),
        judge(*profile, shape, options),
        conversion(model, profile) {}

  BodyPose judgeStart(const FittingInstant& now, const HsiaoVector& v) const;
  BodyPose follow(double seconds, const FittingInstant& now);
  BodyPose carryOn(const VisualHull& hull, const BodyPose& lost);
  BodyPose claim(BodyPose pose, const HsiaoVector& v);
  std::optional<Refinement> startAnew(const FittingInstant& now, int attempts) const;
  Refinement refine(const FittingInstant& now, const HsiaoVector& v) const;
  ProfileFit fitTemporal(const FittingInstant& now, double seconds) const;
  ProfileFit goOn() const;
  bool isReplaced(const FittingInstant& now, const ProfileFit& temporal, const Refinement& kept,
                  Refinement& other);
  bool isTurnBelieved(const Refinement& kept, const Refinement& other);
  void rememberArms(const HsiaoVector& v, const std::array<bool, kPartCount>& seen);
  void forget();
  uint64_t seed() const { return uint64_t(options.seed) * 1000003u; }

  FittingOptions options;
  std::shared_ptr<const BodyModel> model;
  std::shared_ptr<const HsiaoProfile> profile;
  ProfileShape shape;
  HierarchicalFitter fitter;
  PoseRefiner refiner;
  PoseJudge judge;
  HsiaoConversion conversion;

  std::optional<int64_t> stamp, pose_stamp;  // of the last instant, of the last pose from parts
  std::optional<HsiaoVector> last, before;
  BodyPose from_parts;                    // the last one
  HsiaoVector arms_seen = hangingArms();  // arm angles when each was last seen; else unused
  double turn_evidence = 0.0;
};

void PoseTracker::State::forget() {
  last.reset();
  before.reset();
  pose_stamp.reset();
  arms_seen = hangingArms();
  turn_evidence = 0.0;
  conversion.reset();
}

Refinement PoseTracker::State::refine(const FittingInstant& now, const HsiaoVector& v) const {
  HsiaoRange range = fitter.limits();
  HsiaoFrames frames;
  profile->frames(v.data(), frames);
  const std::array<double, kPartCount> errors = judge.partErrors(frames, now);
  for (int side = 0; side < 2; ++side) {
    if (std::isfinite(errors[size_t(PartLabel::kArm1) + side])) continue;
    for (const int k : {3, 5, 7, 9}) {
      const int p = hsiaoTheta(k + side);
      const double reach = k == 9 ? kUnseenElbowReach : kUnseenShoulderReach;
      range.lower[p] = std::max(range.lower[p], arms_seen[p] - reach);
      range.upper[p] = std::min(range.upper[p], arms_seen[p] + reach);
    }
  }
  const HsiaoVector start = v.cwiseMax(range.lower).cwiseMin(range.upper);
  return refiner.refine(start, range, {&now.curves, &now.parts, &now.hull, &now.field});
}

void PoseTracker::State::rememberArms(const HsiaoVector& v,
                                      const std::array<bool, kPartCount>& seen) {
  for (int side = 0; side < 2; ++side)
    if (seen[size_t(PartLabel::kArm1) + side])
      for (const int k : {3, 5, 7, 9}) arms_seen[hsiaoTheta(k + side)] = v[hsiaoTheta(k + side)];
}

std::optional<Refinement> PoseTracker::State::startAnew(const FittingInstant& now,
                                                        int attempts) const {
  std::optional<Refinement> best;
  const HsiaoVector rest = last ? *last : hangingArms();
  for (int attempt = 0; attempt < attempts; ++attempt)
    for (const ProfileFit& fit : fitter.fitAlone(now.curves, rest, seed() + 7919 * attempt)) {
      const Refinement refined = refine(now, fit.v);
      if (!best || refined.cost < best->cost) best = refined;
    }
  return best;
}

ProfileFit PoseTracker::State::fitTemporal(const FittingInstant& now, double seconds) const {
  const double step = std::clamp(seconds, kShortestStep, kLongestStep);
  HsiaoVector reach = HsiaoVector::Constant(options.highest_turn_rate * step);
  reach.segment<6>(kHsiaoCenter).setConstant(options.highest_speed * step);
  std::vector<HsiaoVector> guesses;
  if (before) guesses.push_back(2.0 * *last - *before);
  return fitter.fitNear(now.curves, *last, reach, guesses, seed());
}

// From where the last motion leads the refinement goes the shortest way.
ProfileFit PoseTracker::State::goOn() const {
  ProfileFit fit;
  fit.v = before ? HsiaoVector(2.0 * *last - *before) : *last;
  return fit;
}

bool PoseTracker::State::isTurnBelieved(const Refinement& kept, const Refinement& other) {
  turn_evidence = kEvidenceFade * turn_evidence + (kept.cost - other.cost) / kept.cost;
  turn_evidence = std::max(0.0, turn_evidence);
  return turn_evidence > kTurnEvidence;
}

// Basic against temporal (Hsiao 2008, 3.2.2.5). The hull has the last word, since it tells fingers
// from elbows and toes from heels better than the curves do.
bool PoseTracker::State::isReplaced(const FittingInstant& now, const ProfileFit& temporal,
                                    const Refinement& kept, Refinement& other) {
  const ProfileFit basic = fitter.fitAlone(now.curves, *last, seed()).front();
  const bool turned = facing(*profile, basic.v).dot(facing(*profile, kept.v)) < 0.0;
  const double advantage = temporal.error_m - basic.error_m;
  if (advantage <= (turned ? 0.0 : options.reset_threshold)) {
    turn_evidence *= kEvidenceFade;
    return false;
  }
  other = refine(now, basic.v);
  if (turned) return isTurnBelieved(kept, other);
  return other.cost < kReplaceShare * kept.cost;
}

BodyPose PoseTracker::State::judgeStart(const FittingInstant& now, const HsiaoVector& v) const {
  BodyPose pose = judge.judge(v, now);
  if (pose.status == PoseStatus::kLost) return pose;
  pose.status = PoseStatus::kReinitialized;
  if (!canStartFrom(pose.part_seen)) {
    pose.status = PoseStatus::kLost;
    pose.reason = "a track starts with torso, head and both legs in view; " + pose.reason;
  }
  return pose;
}

BodyPose PoseTracker::State::follow(double seconds, const FittingInstant& now) {
  Refinement found;
  BodyPose pose;
  if (last) {
    const bool legs_told = !areLegsMerged(now.parts);
    const ProfileFit temporal = legs_told ? fitTemporal(now, seconds) : goOn();
    found = refine(now, temporal.v);
    pose = judge.judge(found.v, now);
    Refinement other;
    if (legs_told && isReplaced(now, temporal, found, other)) {
      const BodyPose started = judgeStart(now, other.v);
      if (started.status != PoseStatus::kLost) {
        pose = started;
        found = other;
      }
    }
  }
  if (pose.status == PoseStatus::kLost) {
    found = *startAnew(now, options.start_attempts);
    pose = judgeStart(now, found.v);
  }
  if (pose.status == PoseStatus::kLost) return pose;
  if (pose.status == PoseStatus::kReinitialized) {
    turn_evidence = 0.0;
    before.reset();
  } else {
    before = last;
  }
  rememberArms(found.v, pose.part_seen);
  from_parts = claim(pose, found.v);
  return from_parts;
}

// Legs that pass each other have no parts for some instants; the hull still holds the body.
BodyPose PoseTracker::State::carryOn(const VisualHull& hull, const BodyPose& lost) {
  const BodyParts none;
  const FittingInstant now(*profile, none, hull, options.curve_samples);
  const Refinement found = refine(now, *last);
  BodyPose pose = judge.judge(found.v, now);
  if (pose.status == PoseStatus::kLost ||
      pose.hull_explained < kCarriedShare * from_parts.hull_explained ||
      pose.body_in_hull < kCarriedShare * from_parts.body_in_hull)
    return lost;
  pose.skeleton_error_m = std::numeric_limits<double>::quiet_NaN();
  pose.part_seen = from_parts.part_seen;
  pose.reason = "carried on by the hull alone: " + lost.reason;
  before = last;
  return claim(pose, found.v);
}

BodyPose PoseTracker::State::claim(BodyPose pose, const HsiaoVector& v) {
  last = v;
  conversion.convert(v, pose.T_world_body, pose.angles);
  return pose;
}

PoseTracker::PoseTracker(std::shared_ptr<const BodyModel> model, const FittingOptions& options) {
  options.validate();
  state_ = std::make_unique<State>(std::move(model), options);
}

PoseTracker::~PoseTracker() = default;

const BodyModel& PoseTracker::model() const {
  return *state_->model;
}

void PoseTracker::reset() {
  state_->forget();
  state_->stamp.reset();
}

BodyPose PoseTracker::update(int64_t stamp_ns, const BodyParts& parts, const VisualHull& hull) {
  State& s = *state_;
  if (s.stamp && stamp_ns <= *s.stamp) reset();
  s.stamp = stamp_ns;
  const double seconds = s.pose_stamp ? 1e-9 * double(stamp_ns - *s.pose_stamp) : 0.0;
  if (seconds > s.options.memory) s.forget();
  BodyPose pose;
  pose.reason = hullObstacle(hull);
  if (!pose.reason.empty()) return pose;
  pose.reason = partsObstacle(parts);
  if (pose.reason.empty()) {
    pose = s.follow(seconds, FittingInstant(*s.profile, parts, hull, s.options.curve_samples));
    if (pose.status != PoseStatus::kLost) {
      s.pose_stamp = stamp_ns;
      return pose;
    }
  }
  return s.last ? s.carryOn(hull, pose) : pose;
}

}  // namespace markerless_mocap
