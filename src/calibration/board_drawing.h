#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "calibration/board.h"

namespace markerless_mocap {

/// A rectangle on the board, m, in the frame of the board.
struct BoardBox {
  Eigen::Vector2d lower_left, upper_right;
};

/// The rectangles that are printed: black ones on white, or white ones on black if the board is
/// inverted. Neighbouring cells of a marker's row are joined.
std::vector<BoardBox> printedBoxes(const Board& board);

/// The board as an image (CV_8UC1) with a margin in the colour of its ground.
/// \param pixels_per_metre resolution; a point (x, y) of the board lies at pixel
///   (margin + x, margin + height - y) * pixels_per_metre - 0.5
/// \param margin m, on each side
cv::Mat boardImage(const Board& board, double pixels_per_metre, double margin);

}  // namespace markerless_mocap
