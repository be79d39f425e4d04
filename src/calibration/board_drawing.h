#pragma once

#include <Eigen/Core>
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

}  // namespace markerless_mocap
