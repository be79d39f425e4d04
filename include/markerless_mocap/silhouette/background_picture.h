#pragma once

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

class Background;

/// A background to look at.
struct BackgroundPicture {
  cv::Mat colors;   ///< CV_8UC3 BGR, the most frequent colour of each pixel
  cv::Mat unknown;  ///< CV_8UC1, 255 where the background is not known and `colors` mean nothing
};

/// \param background not empty
BackgroundPicture pictureOf(const Background& background);

}  // namespace markerless_mocap
