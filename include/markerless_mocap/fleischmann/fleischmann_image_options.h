#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the comparison of a drawn body with images.
struct FleischmannImageOptions {
  static constexpr const char* kStage = "appearance";
  int downsampling = 1;
  double edge_threshold = 30.0;
  int edge_dilation = 3;
  double edge_blur = 2.0;
  int edge_samples = 10;
  int min_silhouette_pixels = 50;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
