#include "motion/gait/gait_steps.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/gait_clearance.h"

namespace markerless_mocap {
namespace {

constexpr double kGravity = 9.81;   // m/s^2
constexpr double kSplay = 0.12;     // radians by which each foot points outward
constexpr double kEarly = 0.1;      // seconds by which steps begin before and end after their moves
constexpr double kBothFeet = 0.25;  // fraction of a walking step with both feet on the floor
constexpr double kNoFoot = 0.24;    // fraction of a running step with both feet in the air
constexpr double kTurnRadius =
    0.25;  // metres: turning on the spot counts as walking on a circle of this radius

bool isStepping(const Move& move) {
  return move.kind == Move::Kind::kGo || move.kind == Move::Kind::kShift;
}

double speedOf(const Move& move) {
  const double distance =
      move.kind == Move::Kind::kGo ? std::abs(move.forward) : std::hypot(move.forward, move.left);
  return distance / move.seconds;
}

/// Natural number of steps of a move. The step rate rises with the speed as in adults who choose it
/// freely; both are made dimensionless by the leg length (Hof 1996).
int naturalSteps(const Move& move, double leg) {
  const double speed = (speedOf(move) + kTurnRadius * std::abs(move.turn) / move.seconds) /
                       std::sqrt(kGravity * leg);
  const double rhythm = (move.run ? 0.72 : 0.3 + 0.68 * speed) * std::sqrt(kGravity / leg);
  return std::max(2, int(std::lround(rhythm * move.seconds)));
}

GroundPose footPlace(const GroundPose& middle, bool left, double half_width, double stagger) {
  const double side = left ? 1.0 : -1.0;
  GroundPose place = middle.shifted(side * 0.5 * stagger, side * half_width);
  place.heading += side * kSplay;
  return place;
}

class Planner {
 public:
  Planner(const MotionScript& script, const GaitPath& path, const HumanSkeleton& skeleton)
      : script_(script), path_(path), skeleton_(skeleton), clearance_(skeleton) {
    plan_.left_start = standing(0.0, true, script.start_stance);
    plan_.right_start = standing(0.0, false, script.start_stance);
    now_[0] = plan_.right_start;
    now_[1] = plan_.left_start;
  }

  GaitPlan plan() {
    for (size_t m = 0; m < script_.path.size(); ++m) {
      if (script_.path[m].kind == Move::Kind::kJump) addJump(m);
      if (!isStepping(script_.path[m])) continue;
      const size_t first = m;
      while (m + 1 < script_.path.size() && isStepping(script_.path[m + 1])) ++m;
      addBlock(first, m);
    }
    return plan_;
  }

 private:
  GroundPose standing(double seconds, bool left, const Stance& stance) const {
    return footPlace(path_.at(seconds), left, 0.5 * stance.width * skeleton_.stature,
                     stance.stagger * skeleton_.stature);
  }

  /// Half the distance between the feet. In walking the feet are under the body; less so in slow or
  /// turning motion.
  double halfWidth(const Move& move) const {
    const double leaning =
        std::min(1.0, speedOf(move) / 0.8) * std::exp(-std::abs(move.turn) / move.seconds / 1.5);
    const double fraction = move.run ? 0.016 : 0.042 - 0.014 * leaning;
    return skeleton_.stature * fraction;
  }

  void addJump(size_t m) {
    const Move& move = script_.path[m];
    const double lift = path_.moveTimes()[m], land = path_.moveTimes()[m + 1];
    for (const bool left : {true, false}) {
      // The smoothed path lags at the landing; only the body makes up for this.
      const GroundPose to = standing(land + 0.5, left, move.stance);
      addStep({left, lift, land, now_[size_t(left)], to, Eigen::Vector2d::Zero(), false, true,
               move.tuck});
    }
  }

  void addStep(const GaitStep& step) {
    plan_.steps.push_back(step);
    now_[size_t(step.left)] = step.to;
  }

  GaitBlock makeBlock(size_t first, size_t last) const {
    GaitBlock block;
    block.times.push_back(path_.moveTimes()[first] - kEarly);
    block.phases.push_back(0.0);
    for (size_t m = first; m <= last; ++m) {
      const Move& move = script_.path[m];
      const int steps = move.steps > 0 ? move.steps : naturalSteps(move, skeleton_.legLength());
      block.times.push_back(path_.moveTimes()[m + 1] + (m == last ? kEarly : 0.0));
      block.phases.push_back(block.phases.back() + steps);
      block.moves.push_back(int(m));
    }
    return block;
  }

  /// If the script does not say which foot begins, it is the one on the side of the motion, else
  /// the right one.
  bool leftBegins(const Move& move) const {
    if (move.first != Move::First::kNatural) return move.first == Move::First::kLeft;
    const double left = (move.kind == Move::Kind::kShift ? move.left : 0.0) + 0.1 * move.turn;
    return left > 1e-6;
  }

  void addBlock(size_t first, size_t last) {
    const GaitBlock block = makeBlock(first, last);
    const int count = int(std::lround(block.phases.back()));
    const bool left_begins = leftBegins(script_.path[first]);
    for (int k = 0; k < count; ++k) {
      const Move& move = script_.path[size_t(block.moveAt(k + 0.5))];
      const double margin = 0.5 * (move.run ? -kNoFoot : kBothFeet);
      const bool left = (k % 2 == 0) == left_begins;
      GaitStep step;
      step.left = left;
      step.lift = block.timeOf(k + margin);
      step.land = block.timeOf(k + 1 - margin);
      step.from = now_[size_t(left)];
      step.run = move.run;
      const double middle = k + 1.5;
      if (k + 2 < count) {
        const Move& landing = script_.path[size_t(block.moveAt(middle))];
        step.to = footPlace(path_.at(block.timeOf(middle)), left, halfWidth(landing), 0.0);
      } else {
        step.to = standing(path_.moveTimes()[last + 1] + 0.5, left, script_.path[last].stance);
      }
      const GroundPose& other = now_[size_t(!left)];
      step.to = clearance_.beside(step.to, other);
      step.detour = clearance_.detour(left, step.from, step.to, other);
      addStep(step);
    }
    plan_.blocks.push_back(block);
  }

  const MotionScript& script_;
  const GaitPath& path_;
  const HumanSkeleton& skeleton_;
  const FootClearance clearance_;
  GaitPlan plan_;
  GroundPose now_[2];  ///< of the right and the left foot
};

/// Piecewise linear interpolation, extrapolated with the outer slopes.
double interpolated(const std::vector<double>& from, const std::vector<double>& to, double value) {
  size_t i = 0;
  while (i + 2 < from.size() && value > from[i + 1]) ++i;
  return to[i] + (value - from[i]) / (from[i + 1] - from[i]) * (to[i + 1] - to[i]);
}

}  // namespace

double GaitBlock::phaseAt(double seconds) const {
  return interpolated(times, phases, seconds);
}

double GaitBlock::timeOf(double phase) const {
  return interpolated(phases, times, phase);
}

int GaitBlock::moveAt(double phase) const {
  size_t i = 0;
  while (i + 1 < moves.size() && phase > phases[i + 1]) ++i;
  return moves[i];
}

GaitPlan planGait(const MotionScript& script, const GaitPath& path, const HumanSkeleton& skeleton) {
  return Planner(script, path, skeleton).plan();
}

}  // namespace markerless_mocap
