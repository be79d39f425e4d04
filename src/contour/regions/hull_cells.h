#pragma once

#include <opencv2/core/mat.hpp>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Edge of the cells that the hull is projected into, pixels. \param width of the image
int hullCellEdge(int width);

/// The cells of an image that a voxel of the hull projects into, and their neighbours: CV_8UC1,
/// 0 | 255, one pixel per cell. \param cell edge of a cell, pixels
cv::Mat hullCells(const VisualHull& hull, const Camera& camera, int cell);

/// The mask's value in the middle of each such cell: parts are told apart by cells, as whole images
/// would cost too much. \param cell edge of a cell, pixels
cv::Mat maskCells(const cv::Mat& mask, int cell);

/// The cells of those parts of a mask that meet the cells given: CV_8UC1, 0 | 255. Parts are joined
/// over gaps of a cell. \param mask by cells \param cells CV_8UC1, non-zero where
cv::Mat partsThatMeet(const cv::Mat& mask, const cv::Mat& cells);

/// Gives the pixels in these cells a new value. \param edge of a cell, pixels \param cells CV_8UC1,
/// non-zero where
void setCells(const cv::Mat& cells, int edge, uint8_t value, cv::Mat* mask);

/// The cells of the hull in the size of the image.
cv::Mat hullPixels(const VisualHull& hull, const Camera& camera);

}  // namespace markerless_mocap
