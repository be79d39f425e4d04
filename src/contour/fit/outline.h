#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// A place between a pixel of the person and one of the background, in half pixels: the one odd
/// coordinate tells the direction in which the two are neighbours.
struct Crack {
  int16_t x2, y2;
  Eigen::Vector2d pixel() const { return {0.5 * x2, 0.5 * y2}; }
};

/// All cracks of a mask inside a box, row by row. Neighbours at the image's edge are no cracks, as
/// nobody knows where the person ends there. \param mask CV_8UC1
void findCracks(const cv::Mat& mask, const cv::Rect& box, std::vector<Crack>& cracks);

/// Normal of the border at a crack, out of the person, pixels: away from the middle of the person's
/// pixels in a small disk. Zero where the disk is mirror-symmetric (a line one pixel wide).
/// \param radius of the disk, pixels
Eigen::Vector2d outwardNormal(const cv::Mat& mask, const Crack& crack, int radius);

}  // namespace markerless_mocap
