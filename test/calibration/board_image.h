#pragma once

#include <cmath>
#include <opencv2/core.hpp>

#include "calibration/board_drawing.h"

namespace markerless_mocap {

/// The board as an image (CV_8UC1) with a margin in the colour of its ground.
/// \param pixels_per_metre resolution; a point (x, y) of the board lies at pixel
///   (margin + x, margin + height - y) * pixels_per_metre - 0.5
/// \param margin m, on each side
inline cv::Mat boardImage(const Board& board, double pixels_per_metre, double margin) {
  const Eigen::Vector2d size = board.size() + Eigen::Vector2d::Constant(2 * margin);
  const uint8_t ground = board.options().inverted ? 0 : 255;
  cv::Mat image(int(std::lround(size.y() * pixels_per_metre)),
                int(std::lround(size.x() * pixels_per_metre)), CV_8UC1, cv::Scalar(ground));
  const auto at = [&](double metres) { return int(std::lround(metres * pixels_per_metre)); };
  for (const BoardBox& box : printedBoxes(board)) {
    const int left = at(margin + box.lower_left.x()), right = at(margin + box.upper_right.x());
    const int top = at(size.y() - margin - box.upper_right.y());
    const int bottom = at(size.y() - margin - box.lower_left.y());
    image(cv::Range(top, bottom), cv::Range(left, right)) = 255 - ground;
  }
  return image;
}

}  // namespace markerless_mocap
