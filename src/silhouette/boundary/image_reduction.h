#pragma once

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// The smallest whole number by which both sides of an image must be divided so that it has at most
/// this many million pixels; at least 1.
int reductionOf(const cv::Size& image, double max_megapixels);

/// The image with means over squares of `reduction` x `reduction` pixels in place of pixels. If the
/// sides are no multiples, the last row and column repeat up to the next one.
cv::Mat reducedImage(const cv::Mat& image, int reduction);

/// The mask (0, kUnknownPixel, kPersonPixel) of a reduced image at the size of the image, with
/// smooth outlines of the person.
cv::Mat enlargedMask(const cv::Mat& mask, int reduction, const cv::Size& image);

}  // namespace markerless_mocap
