#include "hsiao/hsiao_pose_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "hsiao/fit/hsiao_hierarchical_fitter.h"
#include "hsiao/fit/hsiao_pose_validator.h"
#include "hsiao/fit/hsiao_refiner.h"
#include "hsiao/model/hsiao_urdf_converter.h"

namespace markerless_mocap {
namespace {

constexpr double kMinStep = 1.0 / 60.0, kMaxStep = 0.2;  // seconds
// A pose with opposite heading is accepted if its relative advantage in cost, summed over frames,
// exceeds this. The sum decays by kEvidenceDecay per frame.
constexpr double kTurnEvidence = 0.6;
constexpr double kEvidenceDecay = 0.8;
// The cost of a basic fit relative to the tracked pose must be lower than this to replace it.
constexpr double kReplaceRatio = 0.95;

// Range of an unseen arm around its last seen angles, radians: the hull constrains the shoulder
// weakly and the elbow hardly at all.
constexpr double kUnseenShoulderRange = 0.4;
constexpr double kUnseenElbowRange = 0.3;

// A pose that is tracked by the hull alone must agree with it nearly as well as the last pose from
// parts.
constexpr double kHullOnlyRatio = 0.93;

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
  return s;
}

HsiaoRefinerSettings refinerSettings(const HsiaoOptions& o) {
  HsiaoRefinerSettings s;
  s.iterations = o.refinement_iterations;
  s.refinement_surface_points = o.refinement_surface_points;
  return s;
}

// Error message if there is no usable hull; else empty.
std::string hullError(const VisualHull& hull) {
  if (hull.status == HullStatus::kOk && !hull.voxels.empty()) return "";
  return hull.reason.empty() ? "there is no hull" : hull.reason;
}

std::string segmentationError(const BodyParts& parts) {
  if (parts.status == SegmentationStatus::kInvalid)
    return parts.reason.empty() ? "the hull has no parts" : parts.reason;
  const PartCurve& torso = parts.part(PartLabel::kTorso);
  if (!torso.seen || !torso.whole || torso.points.size() < 2) return "the torso is not seen";
  return "";
}

// Legs that pass each other touch, and their curves may be exchanged there.
bool areLegsMerged(const BodyParts& parts) {
  const PartCurve& one = parts.part(PartLabel::kLeg1);
  const PartCurve& other = parts.part(PartLabel::kLeg2);
  return (one.seen && !one.whole) || (other.seen && !other.whole);
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

struct HsiaoPoseEstimator::State {
  State(std::shared_ptr<const BodyModel> the_model, const HsiaoOptions& the_options)
      : options(the_options),
        model(std::move(the_model)),
        body_model(std::make_shared<HsiaoBodyModel>(*model)),
        shape(*model, *body_model),
        fitter(*body_model, fitterSettings(options)),
        refiner(*body_model, shape, refinerSettings(options)),
        validator(*body_model, shape, options),
        conversion(model, body_model) {}

  BodyPose validateStart(const HsiaoObservation& now, const HsiaoVector& v) const;
  BodyPose track(double seconds, const HsiaoObservation& now);
  BodyPose trackByHull(const VisualHull& hull, const BodyPose& lost);
  BodyPose report(BodyPose pose, const HsiaoVector& v);
  std::optional<HsiaoRefinement> fitBasicAndRefine(const HsiaoObservation& now, int attempts) const;
  HsiaoRefinement refine(const HsiaoObservation& now, const HsiaoVector& v) const;
  HsiaoFit fitTemporal(const HsiaoObservation& now, double seconds) const;
  HsiaoFit predictConstantVelocity() const;
  bool isReplaced(const HsiaoObservation& now, const HsiaoFit& temporal,
                  const HsiaoRefinement& kept, HsiaoRefinement& other);
  bool isTurnAccepted(const HsiaoRefinement& kept, const HsiaoRefinement& other);
  void storeSeenArms(const HsiaoVector& v, const std::array<bool, kPartCount>& seen);
  void clear();
  uint64_t seed() const { return uint64_t(options.seed) * 1000003u; }

  HsiaoOptions options;
  std::shared_ptr<const BodyModel> model;
  std::shared_ptr<const HsiaoBodyModel> body_model;
  HsiaoBodyShape shape;
  HsiaoHierarchicalFitter fitter;
  HsiaoRefiner refiner;
  HsiaoPoseValidator validator;
  HsiaoUrdfConverter conversion;

  std::optional<int64_t> stamp, pose_stamp;  // of the last frame; of the last pose from parts
  std::optional<HsiaoVector> last, before;
  BodyPose from_parts;                    // last pose from parts
  HsiaoVector arms_seen = hangingArms();  // arm angles when each arm was last seen; other elements
                                          // are unused
  double turn_evidence = 0.0;
};

void HsiaoPoseEstimator::State::clear() {
  last.reset();
  before.reset();
  pose_stamp.reset();
  arms_seen = hangingArms();
  turn_evidence = 0.0;
  conversion.reset();
}

HsiaoRefinement HsiaoPoseEstimator::State::refine(const HsiaoObservation& now,
                                                  const HsiaoVector& v) const {
  HsiaoBounds range = fitter.limits();
  HsiaoFrames frames;
  body_model->frames(v.data(), frames);
  const std::array<double, kPartCount> errors = validator.partErrors(frames, now);
  for (int side = 0; side < 2; ++side) {
    if (std::isfinite(errors[size_t(PartLabel::kArm1) + side])) continue;
    for (const int k : {3, 5, 7, 9}) {
      const int p = hsiaoTheta(k + side);
      const double reach = k == 9 ? kUnseenElbowRange : kUnseenShoulderRange;
      range.lower[p] = std::max(range.lower[p], arms_seen[p] - reach);
      range.upper[p] = std::min(range.upper[p], arms_seen[p] + reach);
    }
  }
  const HsiaoVector start = v.cwiseMax(range.lower).cwiseMin(range.upper);
  return refiner.refine(start, range, {&now.curves, &now.parts, &now.hull, &now.field});
}

void HsiaoPoseEstimator::State::storeSeenArms(const HsiaoVector& v,
                                              const std::array<bool, kPartCount>& seen) {
  for (int side = 0; side < 2; ++side)
    if (seen[size_t(PartLabel::kArm1) + side])
      for (const int k : {3, 5, 7, 9}) arms_seen[hsiaoTheta(k + side)] = v[hsiaoTheta(k + side)];
}

std::optional<HsiaoRefinement> HsiaoPoseEstimator::State::fitBasicAndRefine(
    const HsiaoObservation& now, int attempts) const {
  std::optional<HsiaoRefinement> best;
  const HsiaoVector rest = last ? *last : hangingArms();
  for (int attempt = 0; attempt < attempts; ++attempt)
    for (const HsiaoFit& fit : fitter.fitBasic(now.curves, rest, seed() + 7919 * attempt)) {
      const HsiaoRefinement refined = refine(now, fit.v);
      if (!best || refined.cost < best->cost) best = refined;
    }
  return best;
}

HsiaoFit HsiaoPoseEstimator::State::fitTemporal(const HsiaoObservation& now, double seconds) const {
  const double step = std::clamp(seconds, kMinStep, kMaxStep);
  HsiaoVector reach = HsiaoVector::Constant(options.max_joint_velocity * step);
  reach.segment<6>(kHsiaoCenter).setConstant(options.max_root_speed * step);
  std::vector<HsiaoVector> guesses;
  if (before) guesses.push_back(2.0 * *last - *before);
  return fitter.fitTemporal(now.curves, *last, reach, guesses, seed());
}

// The refinement of the predicted pose has the shortest distance to cover.
HsiaoFit HsiaoPoseEstimator::State::predictConstantVelocity() const {
  HsiaoFit fit;
  fit.v = before ? HsiaoVector(2.0 * *last - *before) : *last;
  return fit;
}

bool HsiaoPoseEstimator::State::isTurnAccepted(const HsiaoRefinement& kept,
                                               const HsiaoRefinement& other) {
  turn_evidence = kEvidenceDecay * turn_evidence + (kept.cost - other.cost) / kept.cost;
  turn_evidence = std::max(0.0, turn_evidence);
  return turn_evidence > kTurnEvidence;
}

// Comparison of basic and temporal PSO (Hsiao 2008, 3.2.2.5). The refined cost decides, because the
// hull distinguishes fingers from elbows and toes from heels better than the curves do.
bool HsiaoPoseEstimator::State::isReplaced(const HsiaoObservation& now, const HsiaoFit& temporal,
                                           const HsiaoRefinement& kept, HsiaoRefinement& other) {
  const HsiaoFit basic = fitter.fitBasic(now.curves, *last, seed()).front();
  const bool turned = facing(*body_model, basic.v).dot(facing(*body_model, kept.v)) < 0.0;
  const double advantage = temporal.error_m - basic.error_m;
  if (advantage <= (turned ? 0.0 : options.reset_threshold)) {
    turn_evidence *= kEvidenceDecay;
    return false;
  }
  other = refine(now, basic.v);
  if (turned) return isTurnAccepted(kept, other);
  return other.cost < kReplaceRatio * kept.cost;
}

BodyPose HsiaoPoseEstimator::State::validateStart(const HsiaoObservation& now,
                                                  const HsiaoVector& v) const {
  BodyPose pose = validator.validate(v, now);
  if (pose.status == PoseStatus::kLost) return pose;
  pose.status = PoseStatus::kReinitialized;
  if (!canStartFrom(pose.part_seen)) {
    pose.status = PoseStatus::kLost;
    pose.reason = "torso, head and both legs must be seen at the start; " + pose.reason;
  }
  return pose;
}

BodyPose HsiaoPoseEstimator::State::track(double seconds, const HsiaoObservation& now) {
  HsiaoRefinement found;
  BodyPose pose;
  if (last) {
    const bool legs_separate = !areLegsMerged(now.parts);
    const HsiaoFit temporal = legs_separate ? fitTemporal(now, seconds) : predictConstantVelocity();
    found = refine(now, temporal.v);
    pose = validator.validate(found.v, now);
    HsiaoRefinement other;
    if (legs_separate && isReplaced(now, temporal, found, other)) {
      const BodyPose started = validateStart(now, other.v);
      if (started.status != PoseStatus::kLost) {
        pose = started;
        found = other;
      }
    }
  }
  if (pose.status == PoseStatus::kLost) {
    found = *fitBasicAndRefine(now, options.initialization_attempts);
    pose = validateStart(now, found.v);
  }
  if (pose.status == PoseStatus::kLost) return pose;
  if (pose.status == PoseStatus::kReinitialized) {
    turn_evidence = 0.0;
    before.reset();
  } else {
    before = last;
  }
  storeSeenArms(found.v, pose.part_seen);
  from_parts = report(pose, found.v);
  return from_parts;
}

// Legs that pass each other have no part curves for some frames; the hull still constrains the
// body.
BodyPose HsiaoPoseEstimator::State::trackByHull(const VisualHull& hull, const BodyPose& lost) {
  const BodyParts none;
  const HsiaoObservation now(*body_model, none, hull, options.samples_per_curve);
  const HsiaoRefinement found = refine(now, *last);
  BodyPose pose = validator.validate(found.v, now);
  if (pose.status == PoseStatus::kLost ||
      pose.hull_explained < kHullOnlyRatio * from_parts.hull_explained ||
      pose.body_in_hull < kHullOnlyRatio * from_parts.body_in_hull)
    return lost;
  pose.skeleton_error_m = std::numeric_limits<double>::quiet_NaN();
  pose.part_seen = from_parts.part_seen;
  pose.reason = "tracked by the hull alone: " + lost.reason;
  before = last;
  return report(pose, found.v);
}

BodyPose HsiaoPoseEstimator::State::report(BodyPose pose, const HsiaoVector& v) {
  last = v;
  conversion.convert(v, pose.T_world_body, pose.angles);
  return pose;
}

HsiaoPoseEstimator::HsiaoPoseEstimator(std::shared_ptr<const BodyModel> model,
                                       const HsiaoOptions& options) {
  options.validate();
  state_ = std::make_unique<State>(std::move(model), options);
}

HsiaoPoseEstimator::~HsiaoPoseEstimator() = default;

const BodyModel& HsiaoPoseEstimator::model() const {
  return *state_->model;
}

void HsiaoPoseEstimator::reset() {
  state_->clear();
  state_->stamp.reset();
}

BodyPose HsiaoPoseEstimator::update(int64_t stamp_ns, const BodyParts& parts,
                                    const VisualHull& hull) {
  State& s = *state_;
  if (s.stamp && stamp_ns <= *s.stamp) reset();
  s.stamp = stamp_ns;
  const double seconds = s.pose_stamp ? 1e-9 * double(stamp_ns - *s.pose_stamp) : 0.0;
  if (seconds > s.options.max_pose_age) s.clear();
  BodyPose pose;
  pose.reason = hullError(hull);
  if (!pose.reason.empty()) return pose;
  pose.reason = segmentationError(parts);
  if (pose.reason.empty()) {
    pose =
        s.track(seconds, HsiaoObservation(*s.body_model, parts, hull, s.options.samples_per_curve));
    if (pose.status != PoseStatus::kLost) {
      s.pose_stamp = stamp_ns;
      return pose;
    }
  }
  return s.last ? s.trackByHull(hull, pose) : pose;
}

}  // namespace markerless_mocap
