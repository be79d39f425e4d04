#include "calibration/board_drawing.h"

#include <cmath>
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

cv::Mat boardImage(const Board& board, double pixels_per_metre, double margin) {
  const Eigen::Vector2d size = board.size() + Eigen::Vector2d::Constant(2 * margin);
  const uint8_t ground = board.options().inverted ? 0 : 255;
  cv::Mat image(int(std::lround(size.y() * pixels_per_metre)),
                int(std::lround(size.x() * pixels_per_metre)), CV_8UC1, cv::Scalar(ground));
  const auto at = [&](double metres) { return int(std::lround(metres * pixels_per_metre)); };
  for (const BoardBox& box : printedBoxes(board)) {
    const int left = at(margin + box.lower_left.x()), right = at(margin + box.upper_right.x());
    const int top = at(size.y() - margin - box.upper_right.y());
    const int bottom = at(size.y() - margin - box.lower_left.y());
    image(cv::Range(top, bottom), cv::Range(left, right)) = 255 - ground;
  }
  return image;
}

}  // namespace markerless_mocap
