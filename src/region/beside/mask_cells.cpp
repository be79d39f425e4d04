#include "region/mask_cells.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace markerless_mocap {
namespace {

constexpr int kWidthPerCell = 80;  // image width divided by the edge of a cell

}  // namespace

int maskCellEdge(int width) {
  return std::max(2, width / kWidthPerCell);
}

cv::Mat maskCells(const cv::Mat& mask, int cell) {
  cv::Mat cells((mask.rows - 1) / cell + 1, (mask.cols - 1) / cell + 1, CV_8UC1);
  const int whole = mask.cols / cell;  // cells that are not cut off by the border
  for (int y = 0; y < cells.rows; ++y) {
    const uchar* row = mask.ptr<uchar>(std::min(y * cell + cell / 2, mask.rows - 1));
    uchar* to = cells.ptr<uchar>(y);
    for (int x = 0; x < whole; ++x) to[x] = row[x * cell + cell / 2];
    if (whole < cells.cols) to[whole] = row[std::min(whole * cell + cell / 2, mask.cols - 1)];
  }
  return cells;
}

cv::Mat partsThatMeet(const cv::Mat& mask, const cv::Mat& cells) {
  cv::Mat joined, labels;
  cv::dilate(mask, joined, cv::Mat());
  const int count = cv::connectedComponents(joined, labels, 8, CV_32S);
  std::vector<bool> meets(size_t(count), false);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (cells.at<uchar>(y, x)) meets[size_t(labels.at<int>(y, x))] = true;
  meets[0] = false;  // the background
  cv::Mat parts(labels.size(), CV_8UC1);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      parts.at<uchar>(y, x) = meets[size_t(labels.at<int>(y, x))] ? 255 : 0;
  return parts;
}

void setCells(const cv::Mat& cells, int edge, uint8_t value, cv::Mat* mask) {
  const cv::Rect image({}, mask->size());
  for (int y = 0; y < cells.rows; ++y) {
    const uchar* row = cells.ptr<uchar>(y);
    for (int x = 0; x < cells.cols; ++x) {
      if (!row[x]) continue;
      const int first = x;
      while (x < cells.cols && row[x]) ++x;
      const cv::Rect run(first * edge, y * edge, (x - first) * edge, edge);
      (*mask)(run & image).setTo(value);
    }
  }
}

}  // namespace markerless_mocap
