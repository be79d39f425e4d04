#include "fleischmann/fleischmann_motion_statistics.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace markerless_mocap {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("motion statistics: " + what);
}

double valueOf(const std::string& name, const YAML::Node& node) {
  double value = NAN;
  try {
    value = node.as<double>();
  } catch (const YAML::Exception&) {
  }
  if (!(value >= 0.0 && std::isfinite(value)))
    refuse(name + " must be a number of at least 0 (maximum change between frames)");
  return value;
}

}  // namespace

const std::array<const char*, kFleischmannParameterCount>& fleischmannParameterNames() {
  static const std::array<const char*, kFleischmannParameterCount> names = {
      "pelvis_roll",
      "pelvis_pitch",
      "pelvis_yaw",
      "pelvis_x",
      "pelvis_y",
      "pelvis_z",
      "left_hip_outward",
      "left_hip_forward",
      "left_hip_twist",
      "left_knee",
      "right_hip_outward",
      "right_hip_forward",
      "right_hip_twist",
      "right_knee",
      "left_clavicle_forward",
      "left_clavicle_up",
      "left_shoulder_outward",
      "left_shoulder_forward",
      "left_shoulder_twist",
      "left_elbow",
      "right_clavicle_forward",
      "right_clavicle_up",
      "right_shoulder_outward",
      "right_shoulder_forward",
      "right_shoulder_twist",
      "right_elbow",
      "spine_forward",
      "spine_sideways",
      "head_sideways",
      "head_down",
      "head_twist"};
  return names;
}

void FleischmannMotionStatistics::add(const FleischmannVector& before, const FleischmannVector& now,
                                      double seconds) {
  if (!(seconds > 0.0)) refuse("the time between two frames must be positive");
  max_change = max_change.cwiseMax((now - before).cwiseAbs() / (60.0 * seconds));
}

std::string FleischmannMotionStatistics::toYaml() const {
  std::string text;
  for (int d = 0; d < kFleischmannParameterCount; ++d) {
    char line[80];
    std::snprintf(line, sizeof(line), "%s: %.5f\n", fleischmannParameterNames()[d], max_change[d]);
    text += line;
  }
  return text;
}

FleischmannMotionStatistics FleischmannMotionStatistics::fromYaml(const std::string& text) {
  YAML::Node map;
  try {
    map = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    refuse(std::string("the text is not YAML: ") + error.what());
  }
  if (!map.IsMap()) refuse("a map from parameters to values is needed");
  FleischmannMotionStatistics statistics;
  for (int d = 0; d < kFleischmannParameterCount; ++d) {
    const YAML::Node node = map[fleischmannParameterNames()[d]];
    if (!node) refuse(std::string(fleischmannParameterNames()[d]) + " is missing");
    statistics.max_change[d] = valueOf(fleischmannParameterNames()[d], node);
  }
  const auto& names = fleischmannParameterNames();
  for (const auto& entry : map) {
    if (!entry.first.IsScalar()) refuse("its keys must be names of parameters");
    const std::string& key = entry.first.Scalar();
    if (std::find(names.begin(), names.end(), key) == names.end())
      refuse("unknown parameter " + key);
  }
  return statistics;
}

}  // namespace markerless_mocap
