#include "markerless_mocap/capture/body_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace markerless_mocap {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kStridesPerSecond = 0.8;
constexpr double kPhaseSeconds = 4.0;
constexpr double kBlendSeconds = 1.2;

/// Angles of one arm by joint, the same sign on both sides.
struct ArmPose {
  double y_shoulder = 0, p_shoulder = 0, r_shoulder = 0, elbow = 0, r_clavicle = 0;

  void add(const ArmPose& other, double weight) {
    y_shoulder += weight * other.y_shoulder;
    p_shoulder += weight * other.p_shoulder;
    r_shoulder += weight * other.r_shoulder;
    elbow += weight * other.elbow;
    r_clavicle += weight * other.r_clavicle;
  }
};

struct ArmPair {
  ArmPose left, right;
};

/// Arms a little off the body, swinging against the legs.
ArmPair swinging(double stride_phase) {
  const double swing = 0.7 * std::sin(stride_phase);
  ArmPair arms;
  arms.left = {-swing, 0.55, -swing, 0.45, 0.0};
  arms.right = {swing, 0.55, swing, 0.45, 0.0};
  return arms;
}

/// The right hand waves beside the head, the left arm is held off the body.
ArmPair waving(double seconds) {
  ArmPair arms;
  arms.left = {0.2, 0.7, 0.2, 0.3, 0.0};
  arms.right = {0.4, 1.55, 1.35, 1.35 + 0.45 * std::sin(2.0 * kPi * 1.1 * seconds), 0.15};
  return arms;
}

/// Both arms spread sideways, moving softly up and down.
ArmPair spread(double seconds) {
  const double lift = 1.45 + 0.35 * std::sin(2.0 * kPi * 0.5 * seconds);
  ArmPair arms;
  arms.left = {0.25, lift, 0.2, 0.25, 0.1};
  arms.right = {0.25, 2.9 - lift, 0.2, 0.25, 0.1};
  return arms;
}

/// Both arms raised in a V, elbows bending in turn.
ArmPair raised(double seconds) {
  const double bend = 0.35 * std::sin(2.0 * kPi * 0.6 * seconds);
  ArmPair arms;
  arms.left = {0.3, 2.45, 0.6, 0.5 + bend, 0.35};
  arms.right = {0.3, 2.45, 0.6, 0.5 - bend, 0.35};
  return arms;
}

/// 0 to 1 with flat ends.
double smoothStep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

/// Share of one of four gestures at a time; the four always sum to 1.
double gestureWeight(int gesture, double seconds) {
  const double round = 4.0 * kPhaseSeconds;
  const double since = std::fmod(seconds - gesture * kPhaseSeconds + 2.0 * round, round);
  const double rise = smoothStep(since / kBlendSeconds);
  const double fall = smoothStep((since - kPhaseSeconds) / kBlendSeconds);
  return rise - fall;
}

/// Bent in the swing phase, nearly straight under load.
double kneeAngle(double stride_phase, double hip_amplitude) {
  const double swing = std::max(0.0, std::cos(stride_phase + 0.6));
  return -(0.12 + 3.2 * hip_amplitude * swing * swing);
}

/// Height of the lowest point of the body's shape.
double lowestPoint(const BodyModel& model, const LinkPoses& poses) {
  double lowest = poses[0].translation().z();
  for (const RoundCone& cone : model.shape()) {
    lowest = std::min(lowest, (poses[cone.link] * cone.a).z() - cone.radius_a);
    lowest = std::min(lowest, (poses[cone.link] * cone.b).z() - cone.radius_b);
  }
  return lowest;
}

}  // namespace

WalkAndWave::WalkAndWave(std::shared_ptr<const BodyModel> model, double walk_radius,
                         double walk_speed)
    : model_(std::move(model)), walk_radius_(walk_radius), yaw_rate_(walk_speed / walk_radius) {
  if (!(walk_radius > 0.0) || !(walk_speed >= 0.0))
    throw std::invalid_argument("the walk needs a radius above 0 m and a speed not below 0 m/s");
  // In half a stride the standing leg sweeps twice its amplitude and the body goes as far.
  const double leg = -(model_->joint("l_knee").T_parent_joint.translation().z() +
                       model_->joint("l_ankle").T_parent_joint.translation().z());
  hip_amplitude_ = std::min(0.5, walk_speed / (4.0 * kStridesPerSecond * leg));
}

double WalkAndWave::period() {
  return 4.0 * kPhaseSeconds;
}

void WalkAndWave::set(const std::string& joint, double angle, Eigen::VectorXd& angles) const {
  const BodyJoint& limits = model_->joint(joint);
  angles[limits.angle_index] = std::clamp(angle, limits.lower, limits.upper);
}

void WalkAndWave::setLegs(double stride_phase, Eigen::VectorXd& angles) const {
  for (const char* side : {"l", "r"}) {
    const double phase = stride_phase + (*side == 'l' ? 0.0 : kPi);
    const std::string prefix = side;
    set(prefix + "_r_hip", 0.08 + hip_amplitude_ * std::sin(phase), angles);
    set(prefix + "_p_hip", 0.04, angles);
    set(prefix + "_knee", kneeAngle(phase, hip_amplitude_), angles);
  }
}

void WalkAndWave::setArms(double seconds, double stride_phase, Eigen::VectorXd& angles) const {
  const ArmPair gestures[] = {swinging(stride_phase), waving(seconds), spread(seconds),
                              raised(seconds)};
  ArmPair arms;
  for (int i = 0; i < 4; ++i) {
    arms.left.add(gestures[i].left, gestureWeight(i, seconds));
    arms.right.add(gestures[i].right, gestureWeight(i, seconds));
  }
  for (const char* side : {"l", "r"}) {
    const ArmPose& arm = *side == 'l' ? arms.left : arms.right;
    const std::string prefix = side;
    set(prefix + "_y_shoulder", arm.y_shoulder, angles);
    set(prefix + "_p_shoulder", arm.p_shoulder, angles);
    set(prefix + "_r_shoulder", arm.r_shoulder, angles);
    set(prefix + "_elbow", arm.elbow, angles);
    set(prefix + "_r_clavicle", arm.r_clavicle, angles);
  }
}

void WalkAndWave::setTrunk(double seconds, double stride_phase, Eigen::VectorXd& angles) const {
  set("waist", 0.06 + 0.02 * std::sin(2.0 * stride_phase), angles);
  set("r_waist", 0.04 * std::cos(stride_phase), angles);
  set("y_head", 0.35 * std::sin(2.0 * kPi * seconds / 7.0), angles);
  set("p_head", 0.1 * std::sin(2.0 * kPi * seconds / 5.0), angles);
}

BodyState WalkAndWave::at(double seconds) const {
  const double stride_phase = 2.0 * kPi * kStridesPerSecond * seconds;
  BodyState state;
  state.angles = Eigen::VectorXd::Zero(model_->angleCount());
  setLegs(stride_phase, state.angles);
  setArms(seconds, stride_phase, state.angles);
  setTrunk(seconds, stride_phase, state.angles);
  const double heading = yaw_rate_ * seconds;
  state.T_world_body = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) *
                       Eigen::Translation3d(0.0, -walk_radius_, 0.0) *
                       Eigen::AngleAxisd(0.03 * std::cos(stride_phase), Eigen::Vector3d::UnitX());
  LinkPoses poses;
  model_->forwardKinematics(state.T_world_body, state.angles, poses);
  state.T_world_body.pretranslate(Eigen::Vector3d(0.0, 0.0, -lowestPoint(*model_, poses)));
  return state;
}

}  // namespace markerless_mocap
