#include "motion/gait/gait_states.h"

#include <algorithm>
#include <cmath>

#include "motion/clip/sampled_signal.h"

namespace markerless_mocap {
namespace {

constexpr double kWeightSoftness = 0.09;  // seconds in which the weight moves from foot to foot
constexpr double kStepSway = 0.3;      // fraction of the distance to the supporting foot, in a step
constexpr double kGestureSway = 0.85;  // the same during a gesture of the other foot
constexpr double kTiptoe =
    0.035;  // fraction of the stature by which stretched feet lift the body in a jump

double smoothStep(double u) {
  const double v = std::clamp(u, 0.0, 1.0);
  return v * v * (3.0 - 2.0 * v);
}

class GaitSampler {
 public:
  GaitSampler(const MotionScript& script, const HumanSkeleton& skeleton, double fps)
      : script_(script),
        skeleton_(skeleton),
        fps_(fps),
        path_(script, fps),
        plan_(planGait(script, path_, skeleton)),
        left_(script, plan_, skeleton, true),
        right_(script, plan_, skeleton, false) {}

  std::vector<GaitState> states() {
    const int count = int(std::lround(script_.seconds * fps_)) + 1;
    for (int i = 0; i < count; ++i) states_.push_back(stateAt(i / fps_));
    smooth(&GaitState::support, kWeightSoftness);
    smooth(&GaitState::stride, 0.03);
    smooth(&GaitState::running, 0.1);
    smooth(&GaitState::moving, 0.1);
    smooth(&GaitState::speeding, 0.1);
    smooth(&GaitState::centripetal, 0.1);
    for (GaitState& state : states_) setAside(state);
    return states_;
  }

 private:
  GaitState stateAt(double t) const {
    GaitState now;
    now.seconds = t;
    now.place = path_.at(t);
    now.left = left_.at(t);
    now.right = right_.at(t);
    const Eigen::Vector2d apart = (now.left.ankle - now.right.ankle).head<2>();
    now.stride = apart.dot(now.place.forward()) / skeleton_.legLength();
    now.support = double(now.left.planted) - double(now.right.planted);
    setPace(t, now);
    for (const GaitBlock& block : plan_.blocks) setRunning(block, t, now);
    for (const GaitStep& step : plan_.steps)
      if (step.jump && step.left) addLeap(step, t, now);
    return now;
  }

  void setPace(double t, GaitState& now) const {
    constexpr double kSpan = 0.05;
    const GroundPose before = path_.at(t - kSpan), after = path_.at(t + kSpan);
    const Eigen::Vector2d v_before = (now.place.position - before.position) / kSpan;
    const Eigen::Vector2d v_after = (after.position - now.place.position) / kSpan;
    const Eigen::Vector2d velocity = 0.5 * (v_before + v_after);
    const double turning = (after.heading - before.heading) / (2.0 * kSpan);
    now.speed = velocity.dot(now.place.forward());
    now.speeding = (v_after - v_before).dot(now.place.forward()) / kSpan;
    now.centripetal = now.speed * turning;
    now.moving = std::min(1.0, velocity.norm() / 0.5 + 0.25 * std::abs(turning));
    now.look = std::clamp(path_.at(t + 0.45).heading - now.place.heading, -0.7, 0.7);
  }

  void setRunning(const GaitBlock& block, double t, GaitState& now) const {
    constexpr double kFade = 0.4;  // seconds in which running fades in and out
    if (t < block.times.front() - kFade || t > block.times.back() + kFade) return;
    const double phase = block.phaseAt(t);
    now.bounce = std::cos(2.0 * M_PI * phase);
    const bool inside = t >= block.times.front() && t <= block.times.back();
    if (inside && script_.path[size_t(block.moveAt(phase))].run) now.running = 1.0;
  }

  void addLeap(const GaitStep& step, double t, GaitState& now) const {
    const double stretched =
        smoothStep((t - step.lift + 0.16) / 0.16) * smoothStep((step.land + 0.18 - t) / 0.18);
    now.leap +=
        leapHeight(t - step.lift, step.land - step.lift) + kTiptoe * skeleton_.stature * stretched;
  }

  void smooth(double GaitState::*field, double seconds) {
    std::vector<double> signal;
    for (const GaitState& state : states_) signal.push_back(state.*field);
    signal = smoothed(signal, seconds * fps_);
    for (size_t i = 0; i < signal.size(); ++i) states_[i].*field = signal[i];
  }

  void setAside(GaitState& now) const {
    const Eigen::Vector2d half = 0.5 * (now.left.ankle - now.right.ankle).head<2>();
    const Eigen::Vector2d across = half.dot(now.place.left()) * now.place.left();
    const double lifted = right_.gestureFraction(now.seconds) -
                          left_.gestureFraction(now.seconds);  // 1: on the left foot
    now.aside =
        kStepSway * (1.0 - std::abs(lifted)) * now.support * across + kGestureSway * lifted * half;
  }

  const MotionScript& script_;
  const HumanSkeleton& skeleton_;
  double fps_;
  GaitPath path_;
  GaitPlan plan_;
  FootTrajectory left_, right_;
  std::vector<GaitState> states_;
};

}  // namespace

std::vector<GaitState> sampleGait(const MotionScript& script, const HumanSkeleton& skeleton,
                                  double fps) {
  return GaitSampler(script, skeleton, fps).states();
}

}  // namespace markerless_mocap
