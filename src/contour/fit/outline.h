#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// The smallest box around all pixels that are not background; empty if there are none. \param mask
/// CV_8UC1, may be empty
cv::Rect shownBox(const cv::Mat& mask);

/// Boundary between a pixel of the person and one of the background, in half pixels. One coordinate
/// is odd; it gives the direction in which the two pixels are neighbours.
struct Crack {
  int16_t x2, y2;
  Eigen::Vector2d pixel() const { return {0.5 * x2, 0.5 * y2}; }
};

/// Finds all cracks of a mask inside a box, row by row. The border of the image is no crack,
/// because the person may continue beyond it; nor is the border of unknown pixels.
/// \param mask CV_8UC1, 0 background, 128 unknown, other values person
void findCracks(const cv::Mat& mask, const cv::Rect& box, std::vector<Crack>& cracks);

constexpr int kMaxNormalRadius = 6;  // pixels

/// Outward normal of the contour at a crack; its length means nothing. It points away from the
/// centroid of the person's pixels in a small disk. Zero if the disk is mirror-symmetric (a line
/// one pixel wide). Beyond the image its border pixels go on. \param radius pixels, at most
/// kMaxNormalRadius
Eigen::Vector2d outwardNormal(const cv::Mat& mask, const Crack& crack, int radius);

}  // namespace markerless_mocap
