#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// Masks by camera, and whether they were in doubt.
struct ClearedMasks {
  std::vector<cv::Mat> masks;
  std::vector<bool> doubted;  ///< parts have become unknown: colours are needed
};

}  // namespace markerless_mocap
