#pragma once

#include <string>

#include "markerless_mocap/fleischmann/fleischmann_image_options.h"

namespace markerless_mocap {

/// Settings of the search by images.
struct FleischmannOptions {
  static constexpr const char* kStage = "sppso";
  std::string search = "two_soft";
  double particle_factor = 1.0;
  int final_stage_particles = 20;
  int final_stage_iterations = 40;
  bool edges = true;
  bool torso_top = true;
  bool include_start_particle = true;
  double prediction = 0.0;
  double sigma_factor = 1.0;
  double collision = 0.85;
  double min_silhouette_fitness = 0.5;
  int seed = 1;
  FleischmannImageOptions appearance;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
