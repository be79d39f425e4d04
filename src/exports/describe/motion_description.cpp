#include "exports/motion_description.h"

#include <algorithm>
#include <cmath>

#include "evaluation/joint_error.h"

namespace markerless_mocap {
namespace {

std::vector<Measure> measuresOf(const std::vector<Step>& steps, Measure Step::*measure, bool left,
                                bool right) {
  std::vector<Measure> out;
  for (const Step& step : steps)
    if (step.left ? left : right) out.push_back(step.*measure);
  return out;
}

/// Contacts of a foot that walks on. Who stands still has one that lasts for as long as that.
std::vector<Measure> walkingContacts(const std::vector<Step>& steps, bool left, bool right) {
  std::vector<Measure> out = measuresOf(steps, &Step::contact_s, left, right);
  out.erase(std::remove_if(out.begin(), out.end(),
                           [](const Measure& contact) { return contact.value > kMaxStep_s; }),
            out.end());
  return out;
}

/// Steps per minute from the times of steps.
Average cadenceOf(const Average& step_s) {
  const double per_minute = 60.0 / step_s.mean, relative = per_minute / step_s.mean;
  return {step_s.count, per_minute, relative * step_s.deviation, relative * step_s.error};
}

}  // namespace

Average averageOf(const std::vector<Measure>& measures) {
  std::vector<double> values;
  double squares = 0.0;
  for (const Measure& measure : measures) {
    if (!std::isfinite(measure.value)) continue;
    values.push_back(measure.value);
    squares += measure.error * measure.error;
  }
  const SummaryStatistics statistics = summaryStatistics(values);
  return {values.size(), statistics.mean, statistics.deviation,
          values.empty() ? double(NAN) : std::sqrt(squares / double(values.size()))};
}

MotionDescription describe(const PersonMotion& motion) {
  MotionDescription out;
  out.seconds = motion.seconds(motion.frames.size() - 1);
  out.frames = motion.frames.size();
  out.frames_with_pose =
      size_t(std::count_if(motion.frames.begin(), motion.frames.end(),
                           [](const PersonFrame& frame) { return frame.hasPose(); }));
  out.steps = stepsOf(motion);
  const auto average = [&](Measure Step::*measure, bool left, bool right) {
    return averageOf(measuresOf(out.steps, measure, left, right));
  };
  out.cadence_per_min = cadenceOf(average(&Step::step_s, true, true));
  out.length_m = average(&Step::length_m, true, true);
  out.width_m = average(&Step::width_m, true, true);
  out.contact_s = averageOf(walkingContacts(out.steps, true, true));
  out.left_length_m = average(&Step::length_m, true, false);
  out.right_length_m = average(&Step::length_m, false, true);
  out.left_contact_s = averageOf(walkingContacts(out.steps, true, false));
  out.right_contact_s = averageOf(walkingContacts(out.steps, false, true));
  out.lean = trunkLean(motion);
  out.ranges = jointRanges(motion);
  return out;
}

}  // namespace markerless_mocap
