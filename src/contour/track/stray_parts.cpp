#include "contour/track/stray_parts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

constexpr uchar kUnknown = 128;    // of a mask
constexpr int kWidthPerCell = 80;  // image width divided by the edge of a cell

// A mask is changed only if the stray parts have this fraction of the area of the others.
constexpr double kMinStray = 0.03;

/// Edge of the cells that a mask and the projected hull are compared in, pixels.
int cellOf(const cv::Mat& mask) {
  return std::max(2, mask.cols / kWidthPerCell);
}

/// CV_8UC1: the cells of the image that a voxel of the hull projects into, and their neighbours.
cv::Mat cellsOfHull(const VisualHull& hull, const Camera& camera, int cell) {
  cv::Mat cells =
      cv::Mat::zeros((camera.height() - 1) / cell + 1, (camera.width() - 1) / cell + 1, CV_8UC1);
  for (const HullVoxel& voxel : hull.voxels)
    if (const auto pixel = camera.projectInside(hull.lattice.center(voxel.index)))
      cells.at<uchar>(std::clamp(int(pixel->y() + 0.5) / cell, 0, cells.rows - 1),
                      std::clamp(int(pixel->x() + 0.5) / cell, 0, cells.cols - 1)) = 255;
  cv::dilate(cells, cells, cv::Mat());
  return cells;
}

/// For each label, whether one of its pixels lies in a cell of the hull.
std::vector<bool> labelsInCells(const cv::Mat& labels, int count, const cv::Mat& cells, int cell) {
  std::vector<bool> inside(size_t(count), false);
  for (int y = 0; y < labels.rows; ++y) {
    const int* label = labels.ptr<int>(y);
    const uchar* row = cells.ptr<uchar>(y / cell);
    for (int x = 0; x < labels.cols; ++x)
      if (label[x] && row[x / cell]) inside[size_t(label[x])] = true;
  }
  return inside;
}

cv::Mat withoutStrayParts(const cv::Mat& mask, const VisualHull& hull, const Camera& camera) {
  if (cv::countNonZero(mask == kUnknown) > 0) return mask;
  cv::Mat labels, areas, middles;
  const int count = cv::connectedComponentsWithStats(mask, labels, areas, middles, 8, CV_32S);
  if (count < 3) return mask;  // the background and one part
  const int cell = cellOf(mask);
  const std::vector<bool> inside =
      labelsInCells(labels, count, cellsOfHull(hull, camera, cell), cell);
  double kept = 0, stray = 0;
  for (int i = 1; i < count; ++i)
    (inside[size_t(i)] ? kept : stray) += areas.at<int>(i, cv::CC_STAT_AREA);
  if (kept == 0 || stray < kMinStray * kept) return mask;
  cv::Mat cleaned = mask.clone();
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (!inside[size_t(labels.at<int>(y, x))]) cleaned.at<uchar>(y, x) = 0;
  return cleaned;
}

}  // namespace

std::vector<cv::Mat> withoutStrayParts(const std::vector<cv::Mat>& masks, const VisualHull& hull,
                                       const CameraRig& rig) {
  std::vector<cv::Mat> cleaned = masks;
  if (hull.voxels.empty() || masks.size() != rig.size()) return cleaned;
  tbb::parallel_for(size_t(0), masks.size(), [&](size_t i) {
    if (!masks[i].empty()) cleaned[i] = withoutStrayParts(masks[i], hull, rig[i]);
  });
  return cleaned;
}

}  // namespace markerless_mocap
