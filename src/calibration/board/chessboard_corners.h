#pragma once

#include <opencv2/core/mat.hpp>

#include "calibration/board.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// All inner corners of a plain chessboard in a grey image whose squares are dark on white; no
/// corners if it was not found whole. The colours of the squares tell which way round it lies, if
/// the board is not the same turned.
/// \param thorough look longer, and in small images also magnified
BoardCorners chessboardCorners(const Board& board, const cv::Mat& grey, bool thorough);

}  // namespace markerless_mocap
