#include "markerless_mocap/fleischmann/fleischmann_image_options.h"

namespace markerless_mocap {

void FleischmannImageOptions::visit(OptionVisitor& v) {
  v.field("reduction", downsampling, 1, 8,
          "whole number by which images are made smaller before the body is compared with them");
  v.field("edge_threshold", edge_threshold, 1.0, 1500.0,
          "length of the Sobel gradient from which a pixel is an edge, grey levels");
  v.field("edge_dilation", edge_dilation, 0, 100,
          "distance from the silhouette up to which edges count, px of the reduced image");
  v.field("edge_blur", edge_blur, 0.1, 50.0,
          "standard deviation of the blur of edges, px of the reduced image");
  v.field("edge_samples", edge_samples, 1, 200, "points compared along each edge of the body");
  v.field("min_silhouette_pixels", min_silhouette_pixels, 1, 1000000,
          "pixels below which a silhouette shows nobody and its view is left out");
}

void FleischmannImageOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
