#pragma once

#include <opencv2/core/mat.hpp>

#include "fleischmann/fitness/fleischmann_cone_outlines.h"
#include "fleischmann/fleischmann_fitness.h"

namespace markerless_mocap {

/// Sum of the edge map at points along the edges of the body, and the number of these points in the
/// image.
struct EdgeSum {
  int64_t sum = 0;  ///< of values 0 to 255
  int points = 0;
};

/// \param samples points per edge, at the centres of equal sections
EdgeSum sampleEdges(const ConeCorners& corners, const cv::Mat& map, const EdgeSelection& choice,
                    int samples);

}  // namespace markerless_mocap
