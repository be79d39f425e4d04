#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "region/region_segmenter.h"

namespace markerless_mocap {

/// Signed distance to the outline of one part, in a box around it.
struct PartDistance {
  cv::Rect box;            ///< of the image; empty if the part is outside
  cv::Mat distance;        ///< CV_32FC1, samples, negative inside
  float depth_inside = 0;  ///< largest distance from the outline inside the part, samples
};

/// The projected body as an image.
struct BodyDrawing {
  static constexpr uchar kNoPart = 255;
  cv::Rect box;                     ///< around all parts and their margin; empty if outside
  std::vector<PartDistance> parts;  ///< boxes relative to the image
  cv::Mat part;      ///< CV_8UC1 in `box`: the part in front, kNoPart outside the body
  cv::Mat distance;  ///< CV_32FC1 in `box`: to the nearest part, samples, negative inside
};

/// The projected body without its parts.
struct BodyDistance {
  cv::Rect box;      ///< around all parts and their margin; empty if outside
  cv::Mat distance;  ///< CV_32FC1 in `box`: to the nearest part, samples, negative inside
};

/// \param margin samples around each part
BodyDistance distanceFrom(const ProjectedBody& body, const cv::Size& size, float margin);
BodyDrawing drawBody(const ProjectedBody& body, int parts, const cv::Size& size, float margin);

}  // namespace markerless_mocap
