#include "markerless_mocap/tracking/pose_filter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kLongestGap = 0.5;         // seconds
constexpr double kFarthestTurn = M_PI / 2;  // radians between two frames
constexpr double kTrendCutoff = 4.0;        // Hz
constexpr double kFullTurn = 2.0 * M_PI;

double shortest(double angle) {
  return std::remainder(angle, kFullTurn);
}

/// Weight that a first-order low-pass gives to the new value.
double smoothingFactor(double cutoff_hz, double seconds) {
  const double turned = kFullTurn * cutoff_hz * seconds;
  return turned / (1.0 + turned);
}

/// Shortest rotation from `a` to `b` in the world.
Vector3d turnBetween(const Quaterniond& a, const Quaterniond& b) {
  const AngleAxisd turn(b * a.conjugate());
  return shortest(turn.angle()) * turn.axis();
}

Quaterniond turnBy(const Vector3d& turn) {
  const double angle = turn.norm();
  return angle > 0.0 ? Quaterniond(AngleAxisd(angle, turn / angle)) : Quaterniond::Identity();
}

/// The same angle up to full turns, within the limits and as near to `raw` as possible; at a limit
/// if no such angle is inside. Unchanged if the raw angle itself exceeds the limits.
double keptWithin(const BodyJoint& joint, double raw, double angle) {
  const double near = raw + shortest(angle - raw);
  if (raw < joint.lower || raw > joint.upper) return near;
  const double other = near > raw ? near - kFullTurn : near + kFullTurn;
  for (const double turned : {near, other})
    if (turned >= joint.lower && turned <= joint.upper) return turned;
  return std::clamp(near, joint.lower, joint.upper);
}

}  // namespace

PoseFilter::PoseFilter(std::shared_ptr<const BodyModel> model, const FilterOptions& options)
    : model_(std::move(model)), cutoff_hz_(options.cutoff), beta_(options.beta) {
  checkFields(options);
}

PoseFilter::State PoseFilter::stateOf(int64_t stamp_ns, const BodyPose& raw) {
  const Vector3d position = raw.T_world_body.translation();
  const Quaterniond rotation(raw.T_world_body.linear());
  return {stamp_ns, position, position, rotation, rotation, raw.angles, raw.angles, std::nullopt};
}

PoseFilter::Speed PoseFilter::speedBetween(const State& last, const State& raw, double seconds) {
  return {(raw.raw_position - last.raw_position) / seconds,
          turnBetween(last.raw_rotation, raw.raw_rotation) / seconds,
          (raw.raw_angles - last.raw_angles).unaryExpr(&shortest) / seconds};
}

std::optional<PoseFilter::Speed> PoseFilter::speedTo(const State& raw, double seconds) const {
  if (seconds <= 0.0 || seconds > kLongestGap) return std::nullopt;
  Speed speed = speedBetween(*state_, raw, seconds);
  const double turning = std::max(speed.rotation.norm(), speed.angles.cwiseAbs().maxCoeff());
  if (turning * seconds > kFarthestTurn) return std::nullopt;
  if (!state_->speed) return speed;
  const double share = smoothingFactor(kTrendCutoff, seconds);
  const Speed& last = *state_->speed;
  speed.position = last.position + share * (speed.position - last.position);
  speed.rotation = last.rotation + share * (speed.rotation - last.rotation);
  speed.angles = last.angles + share * (speed.angles - last.angles);
  return speed;
}

void PoseFilter::follow(const State& raw, const Speed& speed, double seconds) {
  const double fastest =
      std::max({speed.position.norm(), speed.rotation.norm(), speed.angles.cwiseAbs().maxCoeff()});
  const double share = smoothingFactor(cutoff_hz_ + beta_ * fastest, seconds);
  State next = raw;
  next.speed = speed;
  next.position = state_->position + seconds * speed.position;
  next.position += share * (raw.raw_position - next.position);
  next.rotation = (turnBy(seconds * speed.rotation) * state_->rotation)
                      .slerp(share, raw.raw_rotation)
                      .normalized();
  next.angles = state_->angles + seconds * speed.angles;
  next.angles += share * (raw.raw_angles - next.angles).unaryExpr(&shortest);
  state_ = std::move(next);
}

VectorXd PoseFilter::anglesWithinLimits() const {
  VectorXd angles = state_->angles;
  for (const BodyJoint& joint : model_->joints()) {
    const int i = joint.angle_index;
    if (i >= 0) angles[i] = keptWithin(joint, state_->raw_angles[i], angles[i]);
  }
  return angles;
}

BodyPose PoseFilter::filtered(int64_t stamp_ns, const BodyPose& raw) {
  if (raw.status == PoseStatus::kLost) {
    state_.reset();
    return raw;
  }
  if (raw.angles.size() != model_->angleCount())
    throw std::invalid_argument("body " + model_->id() + " has " +
                                std::to_string(model_->angleCount()) + " joint angles, " +
                                std::to_string(raw.angles.size()) + " were given");
  const State now = stateOf(stamp_ns, raw);
  const bool follows = state_ && raw.status == PoseStatus::kTracked;
  const double seconds = follows ? 1e-9 * double(stamp_ns - state_->stamp_ns) : 0.0;
  const std::optional<Speed> speed = follows ? speedTo(now, seconds) : std::nullopt;
  if (!speed) {
    state_ = now;
    return raw;
  }
  follow(now, *speed, seconds);
  BodyPose pose = raw;
  pose.T_world_body.linear() = state_->rotation.toRotationMatrix();
  pose.T_world_body.translation() = state_->position;
  pose.angles = anglesWithinLimits();
  return pose;
}

std::optional<PoseFilter> makePoseFilter(std::shared_ptr<const BodyModel> model,
                                         const FilterOptions& options) {
  if (!options.enabled) return std::nullopt;
  return PoseFilter(std::move(model), options);
}

}  // namespace markerless_mocap
