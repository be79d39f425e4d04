#include "calibration/board_drawing.h"

#include <opencv2/aruco.hpp>

namespace markerless_mocap {
namespace {

/// The cells of a marker with its border: 0 where it is printed.
cv::Mat cellsOf(const BoardOptions& options, int number) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(dictionaryNumber(options.dictionary));
  const int cells = dictionary->markerSize + 2 * options.border_bits;
  cv::Mat image;
  dictionary->drawMarker(number, cells, image, options.border_bits);
  return image;
}

void addMarker(const BoardOptions& options, const BoardMarker& marker,
               std::vector<BoardBox>* boxes) {
  const cv::Mat cells = cellsOf(options, marker.number);
  const double side = options.marker / cells.cols;
  for (int y = 0; y < cells.rows; ++y)
    for (int x = 0, end = 0; x < cells.cols; x = end) {
      end = x + 1;
      if (cells.at<uint8_t>(y, x) != 0) continue;
      while (end < cells.cols && cells.at<uint8_t>(y, end) == 0) ++end;
      const Eigen::Vector2d corner = marker.upper_left;
      boxes->push_back({{corner.x() + x * side, corner.y() - (y + 1) * side},
                        {corner.x() + end * side, corner.y() - y * side}});
    }
}

}  // namespace

std::vector<BoardBox> printedBoxes(const Board& board) {
  const BoardOptions& o = board.options();
  std::vector<BoardBox> boxes;
  for (int row = 0; o.kind != "markers" && row < o.rows; ++row)
    for (int column = 0; column < o.columns; ++column)
      if (board.isDark(row, column))
        boxes.push_back({{column * o.square, (o.rows - row - 1) * o.square},
                         {(column + 1) * o.square, (o.rows - row) * o.square}});
  for (const BoardMarker& marker : board.markers()) addMarker(o, marker, &boxes);
  return boxes;
}

}  // namespace markerless_mocap
