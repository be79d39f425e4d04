#pragma once

#include <string>

#include "fleischmann/fleischmann_body_model.h"

namespace markerless_mocap {

/// Maximum change of each parameter between two frames at 60 fps over a set of motions (Fleischmann
/// 2012, 5.3.2): rad, and metres for the position. It is the motion model of the search.
struct FleischmannMotionStatistics {
  FleischmannVector max_change = FleischmannVector::Zero();

  /// Adds two poses of a motion that are `seconds` apart. Throws std::invalid_argument if `seconds`
  /// is not positive.
  void add(const FleischmannVector& before, const FleischmannVector& now, double seconds);
  /// The maximum change over `seconds`, proportional to time.
  FleischmannVector over(double seconds) const { return max_change * (60.0 * seconds); }

  /// YAML map from fleischmannParameterNames() to values.
  std::string toYaml() const;
  /// Throws std::invalid_argument if a parameter is missing, unknown, negative or no number.
  static FleischmannMotionStatistics fromYaml(const std::string& text);
};

/// Names of the parameters in their order: pelvis_roll, pelvis_pitch, ... head_twist.
const std::array<const char*, kFleischmannParameterCount>& fleischmannParameterNames();

}  // namespace markerless_mocap
