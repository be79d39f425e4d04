#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// Inner corners by rows of a chessboard that is small and seen at a slant, as one on the floor of
/// a room: blur closes the corners between its squares, but the dark squares are still apart. Their
/// middles make the grid, and each corner is refined in the image as seen from straight above the
/// board. Empty if it was not found whole.
/// \param grey dark squares on white  \param inner corners of a row, and rows
std::vector<cv::Point2f> cornersByDarkSquares(const cv::Mat& grey, cv::Size inner);

}  // namespace markerless_mocap
