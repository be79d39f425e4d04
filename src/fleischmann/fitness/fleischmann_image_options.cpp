#include "markerless_mocap/fleischmann/fleischmann_image_options.h"

namespace markerless_mocap {

void FleischmannImageOptions::visit(OptionVisitor& v) {
  v.field("downsampling", downsampling, 1, 8,
          "whole factor by which images are reduced before the body is compared with them");
  v.field("edge_threshold", edge_threshold, 1.0, 1500.0,
          "a pixel is an edge when its Sobel gradient is at least this long, grey levels");
  v.field("edge_dilation", edge_dilation, 0, 100,
          "largest distance of an edge from the silhouette, px of the reduced image");
  v.field("edge_blur_sigma", edge_blur_sigma, 0.1, 50.0,
          "standard deviation of the blur of edges, px of the reduced image");
  v.field("samples_per_edge", samples_per_edge, 1, 200,
          "number of points compared along each edge of the body");
  v.field("hide_covered_edges", hide_covered_edges,
          "leave out points of edges that another part of the body hides");
  v.field("silhouette_weight", silhouette_weight, 0.0, 1.0,
          "a of Eq. 5.5: weight of the part of the silhouette that is drawn; that of the part of "
          "the drawing in the silhouette is 1 - a");
  v.field("min_silhouette_pixels", min_silhouette_pixels, 1, 1000000,
          "a silhouette with fewer pixels shows nobody, and its view is left out");
}

void FleischmannImageOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
