#include "tools/common/description_text.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

using nlohmann::json;

std::string withError(double value, double error, double scale, int digits) {
  const std::string format = "%." + std::to_string(digits) + "f";
  std::string text = formatNumber(format.c_str(), scale * value);
  if (std::isfinite(error)) text += " ± " + formatNumber(format.c_str(), scale * error);
  return text;
}

void addAverage(const std::string& name, const Average& average, double scale, int digits,
                const char* unit, DescriptionSection* out) {
  if (average.count == 0) return;
  const std::string format = "%." + std::to_string(digits) + "f";
  out->rows.push_back({name, withError(average.mean, average.error, scale, digits) + " " + unit +
                                 ", " + formatNumber(format.c_str(), scale * average.deviation) +
                                 " between " + std::to_string(average.count)});
}

DescriptionSection steps(const MotionDescription& motion) {
  constexpr double kCentimetres = 1e2, kMilliseconds = 1e3;
  DescriptionSection out{"steps: " + std::to_string(motion.steps.size()), {}};
  addAverage("cadence", motion.cadence_per_min, 1, 1, "per minute", &out);
  addAverage("length", motion.length_m, kCentimetres, 1, "cm", &out);
  addAverage("length left", motion.left_length_m, kCentimetres, 1, "cm", &out);
  addAverage("length right", motion.right_length_m, kCentimetres, 1, "cm", &out);
  addAverage("width", motion.width_m, kCentimetres, 1, "cm", &out);
  addAverage("contact", motion.contact_s, kMilliseconds, 0, "ms", &out);
  addAverage("contact left", motion.left_contact_s, kMilliseconds, 0, "ms", &out);
  addAverage("contact right", motion.right_contact_s, kMilliseconds, 0, "ms", &out);
  return out;
}

std::string fromTo(double low, double high) {
  return "°, from " + formatNumber("%.1f", low) + "° to " + formatNumber("%.1f", high) + "°";
}

json number(double value) {
  return std::isfinite(value) ? json(value) : json();
}

json measureJson(const Measure& measure) {
  return {{"value", number(measure.value)}, {"expected_error", number(measure.error)}};
}

json averageJson(const Average& average) {
  return {{"count", average.count},
          {"mean", number(average.mean)},
          {"deviation", number(average.deviation)},
          {"expected_error", number(average.error)}};
}

json stepJson(const Step& step) {
  return {{"foot", step.left ? "left" : "right"},   {"time_s", step.seconds},
          {"length_m", measureJson(step.length_m)}, {"width_m", measureJson(step.width_m)},
          {"step_s", measureJson(step.step_s)},     {"contact_s", measureJson(step.contact_s)}};
}

json leanJson(const Average& lean, double low, double high) {
  json out = averageJson(lean);
  out["low"] = number(low);
  out["high"] = number(high);
  return out;
}

}  // namespace

std::vector<DescriptionSection> descriptionSections(const MotionDescription& motion) {
  const TrunkLean& lean = motion.lean;
  DescriptionSection ranges{"ranges of motion (percentiles 1 to 99)", {}};
  for (const JointRange& range : motion.ranges)
    ranges.rows.push_back(
        {range.joint, withError(range.range_deg.value, range.range_deg.error, 1, 1) +
                          fromTo(range.low_deg, range.high_deg)});
  return {steps(motion),
          {"trunk lean",
           {{"forward", withError(lean.forward.mean, lean.forward.error, 1, 1) +
                            fromTo(lean.forward_low, lean.forward_high)},
            {"left", withError(lean.left.mean, lean.left.error, 1, 1) +
                         fromTo(lean.left_low, lean.left_high)}}},
          ranges};
}

void printDescription(const MotionDescription& motion, std::ostream& out) {
  out << formatNumber("%.1f", motion.seconds) << " s, " << motion.frames_with_pose << " of "
      << motion.frames << " frames with a pose; ± is the expected error\n";
  for (const DescriptionSection& section : descriptionSections(motion)) {
    out << section.title << '\n';
    for (const auto& [name, value] : section.rows) printRow(out, name, value);
  }
}

std::string descriptionJson(const MotionDescription& motion) {
  const TrunkLean& lean = motion.lean;
  json out{{"seconds", motion.seconds},
           {"frames", motion.frames},
           {"frames_with_pose", motion.frames_with_pose},
           {"cadence_per_min", averageJson(motion.cadence_per_min)},
           {"step_length_m", averageJson(motion.length_m)},
           {"step_length_left_m", averageJson(motion.left_length_m)},
           {"step_length_right_m", averageJson(motion.right_length_m)},
           {"step_width_m", averageJson(motion.width_m)},
           {"contact_s", averageJson(motion.contact_s)},
           {"contact_left_s", averageJson(motion.left_contact_s)},
           {"contact_right_s", averageJson(motion.right_contact_s)},
           {"trunk_lean_forward_deg", leanJson(lean.forward, lean.forward_low, lean.forward_high)},
           {"trunk_lean_left_deg", leanJson(lean.left, lean.left_low, lean.left_high)},
           {"steps", json::array()}};
  for (const Step& step : motion.steps) out["steps"].push_back(stepJson(step));
  for (const JointRange& range : motion.ranges)
    out["ranges"][range.joint] = {{"low_deg", number(range.low_deg)},
                                  {"high_deg", number(range.high_deg)},
                                  {"range_deg", measureJson(range.range_deg)}};
  return out.dump(1) + '\n';
}

}  // namespace markerless_mocap
