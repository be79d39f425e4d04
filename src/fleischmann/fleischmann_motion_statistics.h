#pragma once

#include <string>

#include "fleischmann/fleischmann_body_model.h"

namespace markerless_mocap {

/// How much each of F's parameters changes between two frames at 60 fps, at most, over a set of
/// motions (Fleischmann 2012, 5.3.2): rad, and metres for the position. The model of motion that
/// a search by images goes by.
struct FleischmannMotionStatistics {
  FleischmannVector max_change = FleischmannVector::Zero();

  /// Takes in two poses of a motion, `seconds` apart. Throws std::invalid_argument unless that is
  /// above 0.
  void add(const FleischmannVector& before, const FleischmannVector& now, double seconds);
  /// The changes over `seconds`: scaled by the time against 1/60 s.
  FleischmannVector over(double seconds) const { return max_change * (60.0 * seconds); }

  /// Text of a YAML map from fleischmannParameterNames() to values.
  std::string toYaml() const;
  /// Throws std::invalid_argument with one sentence if a parameter is missing, unknown, negative or
  /// no number.
  static FleischmannMotionStatistics fromYaml(const std::string& text);
};

/// Names of F's parameters in their order: pelvis_roll, pelvis_pitch, ... head_twist.
const std::array<const char*, kFleischmannParameterCount>& fleischmannParameterNames();

}  // namespace markerless_mocap
