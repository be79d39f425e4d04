#pragma once

#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of one camera's silhouette stage.
struct SilhouetteOptions {
  static constexpr const char* kStage = "silhouette";
  std::string model = "gaussian";
  int background_frames = 30;
  double threshold_sigmas = 3.0;
  double min_sigma = 4.0;
  double update_rate = 0.004;
  bool compensate_flicker = true;
  bool remove_shadows = true;
  double min_shadow_brightness = 0.55;
  double shadow_chroma_tolerance = 0.018;
  int open_radius_px = 1;
  int close_radius_px = 1;
  int max_hole_px = 10;
  int min_blob_px = 200;
  double stale_fraction = 0.5;
  int stale_frames = 60;

  void visit(OptionVisitor& v);
  /// Throws std::invalid_argument naming key, value and allowed range.
  void validate() const;
};

}  // namespace markerless_mocap
