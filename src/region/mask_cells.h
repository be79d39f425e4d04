#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Edge of the cells that parts of a mask are told apart by, pixels: whole images would cost too
/// much. \param width of the image
int maskCellEdge(int width);

/// The mask's value in the middle of each cell. \param cell edge of a cell, pixels
cv::Mat maskCells(const cv::Mat& mask, int cell);

/// The cells of those parts of a mask that meet the cells given: CV_8UC1, 0 | 255. Parts are joined
/// over gaps of a cell. \param mask by cells \param cells CV_8UC1, non-zero where
cv::Mat partsThatMeet(const cv::Mat& mask, const cv::Mat& cells);

/// Gives the pixels in these cells a new value. \param edge of a cell, pixels \param cells CV_8UC1,
/// non-zero where
void setCells(const cv::Mat& cells, int edge, uint8_t value, cv::Mat* mask);

}  // namespace markerless_mocap
