#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "calibration/board.h"

namespace markerless_mocap {

/// What images show in place of a board that was not found in them: a white pattern on black,
/// markers of another dictionary, a chessboard of one more square each way (inner corners were
/// counted). A sentence with the option that would find it; empty if nothing is clear.
/// \param images CV_8UC1 or CV_8UC3
std::string otherBoardIn(const Board& board, const std::vector<cv::Mat>& images);

}  // namespace markerless_mocap
