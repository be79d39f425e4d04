#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Weight that Eq. 3-14 adds for two colours at this distance in RGB.
double similarityWeight(double d);

/// A figure in the plane with thin limbs and a thick trunk and head, each of one colour (after
/// Hsiao 2008, Fig. 3-12 a): BGR on black.
cv::Mat testImage();

/// Weights of the edges in an image's graph.
struct PixelGraphOptions {
  bool color = false;  ///< Eq. 3-14: similarity adds up to 1, dissimilarity subtracts 0.9
  double shrink = 0;   ///< added to each edge of a pixel with all 24 neighbours
};

/// The graph of the pixels of an image that are not black. Each is connected to those within two
/// pixels along both axes (24-neighbourhood).
struct PixelGraph {
  WeightedGraph graph;
  std::vector<cv::Point> pixel;  ///< of each node
};
PixelGraph pixelGraph(const cv::Mat& image, const PixelGraphOptions& weights);

}  // namespace markerless_mocap
