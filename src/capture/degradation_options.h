#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// What makes the virtual studio's film as hard as a real one, one number each; 0 is no trouble. A
/// part of the studio's section.
struct DegradationOptions {
  static constexpr const char* kStage = "virtual_studio";
  double noise_levels = 3.0;
  double flicker = 0.01;
  double shadow_strength = 0.35;
  double camouflage = 0.0;
  double mask_damage = 0.0;
  double calibration_error_px = 0.0;
  double time_offset_ms = 0.0;
  double drop_rate = 0.0;
  double exposure_ms = 0.0;
  double second_person = 0.0;
  double chair = 0.0;

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
