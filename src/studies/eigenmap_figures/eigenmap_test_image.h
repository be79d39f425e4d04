#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// A figure in the plane whose limbs are thin, whose trunk and head are thick, each of one colour
/// (as Hsiao 2008, Fig. 3-12 a): BGR on black.
cv::Mat testImage();

/// How the edges of an image's graph are weighted.
struct PixelGraphOptions {
  bool color = false;  ///< Eq. 3-14: likeness adds up to 1, unlikeness takes 0.9
  double shrink = 0;   ///< added to each edge of a pixel that has all 24 neighbours
};

/// The graph of an image's pixels that are not black, each with those within two pixels along both
/// axes (24-neighbourhood).
struct PixelGraph {
  WeightedGraph graph;
  std::vector<cv::Point> pixel;  ///< of each node
};
PixelGraph pixelGraph(const cv::Mat& image, const PixelGraphOptions& weights);

}  // namespace markerless_mocap
