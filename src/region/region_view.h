#pragma once

#include <opencv2/core/mat.hpp>

#include "region/region_segmenter.h"

namespace markerless_mocap {

/// What one camera shows, sampled for the search by colour. Both are empty where colours need not
/// decide.
struct RegionView {
  int step = 1;    ///< pixels between samples
  cv::Mat colors;  ///< CV_8UC3 BGR, samples; empty without colours
  cv::Mat known;   ///< the mask at the samples
};

/// Every second pixel up to VGA, fewer of larger images.
/// \param image CV_8UC3 BGR of the size of the mask, or empty
/// \param mask CV_8UC1 0 | 128 unknown | 255
RegionView regionView(const cv::Mat& image, const cv::Mat& mask);

/// The same with half as many samples along each axis.
RegionView coarser(const RegionView& view);

/// Whether the background is not known near the body. \param known a mask at the samples
bool isUnknownNear(const ProjectedBody& body, const cv::Mat& known);

/// A mask at the samples, enlarged to the image with smooth borders.
/// \param samples CV_8UC1, 0 | 255
cv::Mat enlarged(const cv::Mat& samples, int step, const cv::Size& image);

}  // namespace markerless_mocap
