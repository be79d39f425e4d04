#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the comparison of a drawn body with images.
struct FleischmannImageOptions {
  static constexpr const char* kStage = "pose_fitting/fleischmann";
  /// whole factor by which images are reduced before the body is compared with them
  int downsampling = 1;
  /// a pixel is an edge when its Sobel gradient is at least this long, grey levels
  double edge_threshold = 30.0;
  /// largest distance of an edge from the silhouette, px of the reduced image
  int edge_dilation = 3;
  /// standard deviation of the blur of edges, px of the reduced image
  double edge_blur_sigma = 2.0;
  /// number of points compared along each edge of the body
  int samples_per_edge = 10;
  /// leave out points of edges that another part of the body hides
  bool hide_covered_edges = false;
  /// a of Eq. 5.5: weight of the part of the silhouette that is drawn; that of the part of the
  /// drawing in the silhouette is 1 - a
  double silhouette_weight = 0.5;
  /// a silhouette with fewer pixels shows nobody, and its view is left out
  int min_silhouette_pixels = 50;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
