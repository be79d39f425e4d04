#pragma once

#include <string>

#include "capture/degradation_options.h"
#include "character/character_options.h"
#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the virtual studio.
struct StudioOptions {
  static constexpr const char* kStage = "virtual_studio";
  std::string motion = "wave_and_walk";
  double motion_start = 0.0;
  double bend_radius = 0.0;
  double duration = 0.0;
  double stage = 1.8;
  std::string rig = "ring7_overhead";
  int width = 640;
  int height = 480;
  double distortion_k1 = 0.0;
  double fps = 30.0;
  int background_frames = 30;
  int seed = 1;
  std::string character_file;
  CharacterOptions character;
  DegradationOptions degradations;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
