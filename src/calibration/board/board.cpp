#include "calibration/board.h"

#include <array>
#include <opencv2/aruco.hpp>
#include <stdexcept>

namespace markerless_mocap {

const std::vector<std::string>& dictionaryNames() {
  using namespace std::string_literals;  // in the order of OpenCV's numbers
  static const std::vector<std::string> kNames = {
      "DICT_4X4_50"s,         "DICT_4X4_100"s,       "DICT_4X4_250"s,       "DICT_4X4_1000"s,
      "DICT_5X5_50"s,         "DICT_5X5_100"s,       "DICT_5X5_250"s,       "DICT_5X5_1000"s,
      "DICT_6X6_50"s,         "DICT_6X6_100"s,       "DICT_6X6_250"s,       "DICT_6X6_1000"s,
      "DICT_7X7_50"s,         "DICT_7X7_100"s,       "DICT_7X7_250"s,       "DICT_7X7_1000"s,
      "DICT_ARUCO_ORIGINAL"s, "DICT_APRILTAG_16h5"s, "DICT_APRILTAG_25h9"s, "DICT_APRILTAG_36h10"s,
      "DICT_APRILTAG_36h11"s};
  return kNames;
}

namespace {

std::vector<Eigen::Vector2d> innerCorners(const BoardOptions& o) {
  std::vector<Eigen::Vector2d> corners;
  for (int y = 1; y < o.rows; ++y)
    for (int x = 1; x < o.columns; ++x) corners.emplace_back(x * o.square, y * o.square);
  return corners;
}

std::vector<BoardMarker> gridMarkers(const BoardOptions& o) {
  std::vector<BoardMarker> markers;
  for (int y = 0; y < o.rows; ++y)
    for (int x = 0; x < o.columns; ++x)
      markers.push_back(
          {o.first_marker + int(markers.size()), {x * o.square, y * o.square + o.marker}});
  return markers;
}

std::vector<Eigen::Vector2d> cornersOfMarkers(const std::vector<BoardMarker>& markers,
                                              double side) {
  std::vector<Eigen::Vector2d> corners;
  for (const BoardMarker& marker : markers)
    for (const Eigen::Vector2d& step : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0),
                                        Eigen::Vector2d(1, -1), Eigen::Vector2d(0, -1)})
      corners.push_back(marker.upper_left + side * step);
  return corners;
}

void refuse(const std::string& what) {
  throw std::invalid_argument("board: " + what);
}

void checkMarkers(const BoardOptions& o, int markers) {
  if (!(o.marker < o.square))
    refuse("marker is " + std::to_string(o.marker) + " m, it must be smaller than square, " +
           std::to_string(o.square) + " m");
  const int known =
      cv::aruco::getPredefinedDictionary(dictionaryNumber(o.dictionary))->bytesList.rows;
  if (o.first_marker + markers > known)
    refuse("it needs the markers " + std::to_string(o.first_marker) + " to " +
           std::to_string(o.first_marker + markers - 1) + ", dictionary " + o.dictionary + " has " +
           std::to_string(known));
}

}  // namespace

int dictionaryNumber(const std::string& name) {
  const auto& names = dictionaryNames();
  for (size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return int(i);
  throw std::invalid_argument("there is no marker dictionary " + name);
}

void BoardOptions::visit(OptionVisitor& v) {
  v.field(
      "kind", kind, {"charuco", "markers", "chessboard"},
      "charuco: chessboard with markers in its white squares; markers: grid of markers, such as "
      "an AprilTag grid; chessboard: plain");
  v.field("columns", columns, 1, 100,
          "squares across (not inner corners); markers across for a grid of markers");
  v.field("rows", rows, 1, 100, "squares from top to bottom; markers for a grid of markers");
  v.field("square", square, 0.001, 10.0,
          "side of a square, m; of a grid of markers: from one marker to the next, side and gap "
          "together");
  v.field("marker", marker, 0.0005, 10.0, "side of a marker with its black border, m");
  v.field("dictionary", dictionary, dictionaryNames(), "marker dictionary by its name in OpenCV");
  v.field(
      "first_marker", first_marker, 0, 999,
      "number of the first marker: the upper left one; of a grid of markers the lower left one");
  v.field("border_bits", border_bits, 1, 4,
          "width of the markers' black border in cells; 2 for Kalibr's AprilTag grids");
  v.field("inverted", inverted, "white pattern on a black board");
  v.field("white_first", white_first,
          "charuco boards with an even number of rows that begin with a white square at the upper "
          "left, as OpenCV before 4.6 made them");
}

void BoardOptions::validate() const {
  checkFields(*this);
  const int least = kind == "markers" ? 1 : 3;
  if (columns < least || rows < least)
    refuse("it has " + std::to_string(columns) + " x " + std::to_string(rows) +
           " squares, a chessboard must have at least 3 x 3; count squares, not inner corners");
  if (kind == "chessboard" && columns == rows)
    refuse("a plain chessboard of " + std::to_string(columns) + " x " + std::to_string(rows) +
           " squares looks the same from four sides; columns and rows must differ");
  if (kind == "charuco") checkMarkers(*this, columns * rows / 2);
  if (kind == "markers") checkMarkers(*this, columns * rows);
}

Board::Board(const BoardOptions& options) : options_(options) {
  options_.validate();
  if (options_.kind == "markers") {
    markers_ = gridMarkers(options_);
    corners_ = cornersOfMarkers(markers_, options_.marker);
    return;
  }
  corners_ = innerCorners(options_);
  if (options_.kind != "charuco") return;
  const double gap = (options_.square - options_.marker) / 2;
  for (int row = 0; row < options_.rows; ++row)
    for (int column = 0; column < options_.columns; ++column)
      if (!isDark(row, column))
        markers_.push_back(
            {options_.first_marker + int(markers_.size()),
             {column * options_.square + gap, (options_.rows - row) * options_.square - gap}});
}

Eigen::Vector2d Board::size() const {
  const Eigen::Vector2d squares(options_.columns, options_.rows);
  if (options_.kind != "markers") return squares * options_.square;
  return (squares.array() - 1).matrix() * options_.square +
         Eigen::Vector2d::Constant(options_.marker);
}

bool Board::isDark(int row, int column) const {
  const bool shifted = options_.white_first && options_.rows % 2 == 0;
  return (row + column + (shifted ? 1 : 0)) % 2 == 0;
}

bool Board::looksSameTurned() const {
  return options_.kind == "chessboard" && (options_.rows + options_.columns) % 2 == 0;
}

}  // namespace markerless_mocap
