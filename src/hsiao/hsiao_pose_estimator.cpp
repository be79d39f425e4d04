#include "hsiao/hsiao_pose_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "hsiao/fit/hsiao_pose_search.h"
#include "hsiao/model/hsiao_urdf_converter.h"

namespace markerless_mocap {
namespace {

// A pose with opposite heading is accepted if its relative advantage in cost, summed over frames,
// exceeds this. The sum decays by kEvidenceDecay per frame.
constexpr double kTurnEvidence = 0.6;
constexpr double kEvidenceDecay = 0.8;
// The cost of a basic fit relative to the tracked pose must be lower than this to replace it.
constexpr double kReplaceRatio = 0.95;

// A pose that is tracked by the hull alone must agree with it nearly as well as the last pose from
// parts.
constexpr double kHullOnlyRatio = 0.93;

// Error message if there is no usable hull; else empty.
std::string hullError(const VisualHull& hull) {
  if (hull.status == HullStatus::kOk && !hull.voxels.empty()) return "";
  return hull.reason.empty() ? "there is no hull" : hull.reason;
}

std::string segmentationError(const BodyParts& parts, bool use_hull) {
  if (use_hull && parts.status == SegmentationStatus::kInvalid)
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

}  // namespace

struct HsiaoPoseEstimator::State {
  State(std::shared_ptr<const BodyModel> the_model, const HsiaoOptions& the_options)
      : options(the_options),
        model(std::move(the_model)),
        body_model(std::make_shared<HsiaoBodyModel>(*model)),
        search(*model, body_model, options),
        conversion(model, body_model) {}

  BodyPose track(double seconds, const HsiaoObservation& now);
  BodyPose trackByHull(const VisualHull& hull, const BodyPose& lost);
  BodyPose report(BodyPose pose, const HsiaoVector& v);
  HsiaoFit predictConstantVelocity() const;
  bool isReplaced(const HsiaoObservation& now, const HsiaoFit& temporal,
                  const HsiaoRefinement& kept, HsiaoRefinement& other);
  bool isTurnAccepted(const HsiaoRefinement& kept, const HsiaoRefinement& other);
  void clear();

  HsiaoOptions options;
  std::shared_ptr<const BodyModel> model;
  std::shared_ptr<const HsiaoBodyModel> body_model;
  HsiaoPoseSearch search;
  HsiaoUrdfConverter conversion;

  std::optional<int64_t> stamp, pose_stamp;  // of the last frame; of the last pose from parts
  std::optional<HsiaoVector> last, before;
  BodyPose from_parts;  // last pose from parts
  double turn_evidence = 0.0;
};

void HsiaoPoseEstimator::State::clear() {
  last.reset();
  before.reset();
  pose_stamp.reset();
  search.forgetArms();
  turn_evidence = 0.0;
  conversion.reset();
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

// Comparison of basic and temporal PSO (Hsiao 2008, 3.2.2.5). If the hull is used, the refined cost
// decides, because the hull distinguishes fingers from elbows and toes from heels better than the
// curves do.
bool HsiaoPoseEstimator::State::isReplaced(const HsiaoObservation& now, const HsiaoFit& temporal,
                                           const HsiaoRefinement& kept, HsiaoRefinement& other) {
  const HsiaoFit basic = search.fitBasicOnce(now, *last);
  const double advantage = temporal.error_m - basic.error_m;
  if (!options.use_hull) {
    other = search.refine(now, basic);
    return advantage > options.reset_threshold;
  }
  const bool turned = search.areOpposite(basic.v, kept.v);
  if (advantage <= (turned ? 0.0 : options.reset_threshold)) {
    turn_evidence *= kEvidenceDecay;
    return false;
  }
  other = search.refine(now, basic);
  if (turned) return isTurnAccepted(kept, other);
  return other.cost < kReplaceRatio * kept.cost;
}

BodyPose HsiaoPoseEstimator::State::track(double seconds, const HsiaoObservation& now) {
  HsiaoRefinement found;
  BodyPose pose;
  if (last) {
    const bool legs_separate = !options.use_hull || !areLegsMerged(now.parts);
    const HsiaoFit temporal =
        legs_separate ? search.fitTemporal(now, *last, before, seconds) : predictConstantVelocity();
    found = search.refine(now, temporal);
    pose = search.validate(found.v, now);
    HsiaoRefinement other;
    if (legs_separate && isReplaced(now, temporal, found, other)) {
      const BodyPose started = search.validateStart(now, other.v);
      if (started.status != PoseStatus::kLost) {
        pose = started;
        found = other;
      }
    }
  }
  if (pose.status == PoseStatus::kLost) {
    found = search.fitBasic(now, last, options.initialization_attempts);
    pose = search.validateStart(now, found.v);
  }
  if (pose.status == PoseStatus::kLost) return pose;
  if (pose.status == PoseStatus::kReinitialized) {
    turn_evidence = 0.0;
    before.reset();
  } else {
    before = last;
  }
  search.storeSeenArms(found.v, pose.part_seen);
  from_parts = report(pose, found.v);
  return from_parts;
}

// Legs that pass each other have no part curves for some frames; the hull still constrains the
// body.
BodyPose HsiaoPoseEstimator::State::trackByHull(const VisualHull& hull, const BodyPose& lost) {
  const BodyParts none;
  const HsiaoObservation now(*body_model, none, hull, options);
  const HsiaoRefinement found = search.refine(now, {*last, 0.0});
  BodyPose pose = search.validate(found.v, now);
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
  pose.reason = segmentationError(parts, s.options.use_hull);
  if (pose.reason.empty()) {
    pose = s.track(seconds, HsiaoObservation(*s.body_model, parts, hull, s.options));
    if (pose.status != PoseStatus::kLost) {
      s.pose_stamp = stamp_ns;
      return pose;
    }
  }
  return s.last && s.options.use_hull ? s.trackByHull(hull, pose) : pose;
}

}  // namespace markerless_mocap
