#pragma once

#include <string>

#include "markerless_mocap/fleischmann/appearance_options.h"

namespace markerless_mocap {

/// Settings of the search by images.
struct SppsoOptions {
  static constexpr const char* kStage = "sppso";
  std::string search = "two_soft";
  double evaluations_factor = 1.0;
  int last_particles = 20;
  int last_iterations = 40;
  bool edges = true;
  bool torso_top = true;
  bool keep_start = false;
  double prediction = 0.0;
  double sigma_factor = 1.0;
  double collision = 0.85;
  double least_fitness = 0.5;
  int seed = 1;
  AppearanceOptions appearance;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
