#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "calibration/board.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// All inner corners of a plain chessboard in a grey image whose squares are dark on white; no
/// corners if it was not found whole. The colours of the squares tell which way round it lies, if
/// the board is not the same turned.
/// \param thorough look longer, and in small images also magnified
/// \param before corners in the image before, about which the board is looked for first; or nullptr
BoardCorners chessboardCorners(const Board& board, const cv::Mat& grey, bool thorough,
                               const BoardCorners* before = nullptr);

/// Whether neighbouring sides among corners by rows are nearly alike, and all cells turn the same
/// way. OpenCV's longer search returns grids of which a part lies on other things.
/// \param inner corners of a row, and rows
bool isGrid(const std::vector<cv::Point2f>& found, cv::Size inner);

}  // namespace markerless_mocap
