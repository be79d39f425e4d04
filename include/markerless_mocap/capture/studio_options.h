#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the virtual studio.
struct StudioOptions {
  static constexpr const char* kStage = "virtual_studio";
  int cameras = 8;
  bool overhead = true;
  int width = 640;
  int height = 480;
  double horizontal_view_deg = 60.0;
  double ring_radius = 3.5;
  double ring_height = 2.2;
  double overhead_height = 4.0;
  double distortion_k1 = 0.0;
  double fps = 30.0;
  double duration = 16.0;
  int background_frames = 30;
  double stature = 1.75;
  double walk_radius = 0.5;
  double walk_speed = 0.6;
  double noise_levels = 2.0;
  int seed = 1;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
