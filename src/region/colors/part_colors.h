#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "region/body_drawing.h"
#include "region/colors/color_histogram.h"

namespace markerless_mocap {

/// Colours of one part of the person and of what surrounds it in one view.
struct PartColors {
  ColorHistogram person, surroundings;
};

/// Learns the colours of all parts. The core of a part, which a small error of the pose does not
/// move out of the person, gives the person's colours; a ring around the body gives those of the
/// surroundings.
/// \param bins CV_16UC1 in drawing.box, see ColorBins
void learnColors(const cv::Mat& bins, const BodyDrawing& drawing, float sigma, float person_rate,
                 float surroundings_rate, std::vector<PartColors>& colors);

/// Log odds that a sample shows the person, by colour, CV_32FC1 in drawing.box. Parts near the
/// sample are mixed by their distance. 0 where no colour is known.
cv::Mat colorLogOdds(const cv::Mat& bins, const BodyDrawing& drawing, float sigma,
                     const std::vector<PartColors>& colors);

/// Samples whose colour is more frequent in the person, whatever part, than in the surroundings.
/// \return CV_8UC1 of the size of `bins`, 0 | 255
cv::Mat personColored(const cv::Mat& bins, const std::vector<PartColors>& colors);

}  // namespace markerless_mocap
