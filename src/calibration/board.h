#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Description of a flat calibration board.
struct BoardOptions {
  static constexpr const char* kStage = "board";
  /// charuco: chessboard with markers in its white squares; markers: grid of markers, such as an
  /// AprilTag grid; chessboard: plain
  std::string kind = "charuco";
  /// squares across (not inner corners); markers across for a grid of markers
  int columns = 7;
  /// squares from top to bottom; markers for a grid of markers
  int rows = 5;
  /// side of a square, m; of a grid of markers: from one marker to the next, side and gap together
  double square = 0.035;
  /// side of a marker with its black border, m
  double marker = 0.026;
  /// marker dictionary by its name in OpenCV
  std::string dictionary = "DICT_4X4_50";
  /// number of the first marker: the upper left one; of a grid of markers the lower left one
  int first_marker = 0;
  /// width of the markers' black border in cells; 2 for Kalibr's AprilTag grids
  int border_bits = 1;
  /// white pattern on a black board
  bool inverted = false;
  /// charuco boards with an even number of rows that begin with a white square at the upper left,
  /// as OpenCV before 4.6 made them
  bool white_first = false;

  /// Throws std::invalid_argument; the message names the key, the value and what is allowed.
  void validate() const;
  void visit(OptionVisitor& v);
};

/// Reads a board file: a YAML map of BoardOptions' keys, or the charuco.toml of caliscope. Throws
/// std::invalid_argument or std::runtime_error; the message names the file and the key.
BoardOptions readBoard(const std::string& path);
/// The text of a board file, with a comment for each key.
std::string boardText(const BoardOptions& options);

/// Marker dictionaries by their names in OpenCV, in the order of its numbers.
const std::vector<std::string>& dictionaryNames();
/// OpenCV's number of a dictionary. Throws std::invalid_argument on an unknown name.
int dictionaryNumber(const std::string& name);

/// A marker of a board.
struct BoardMarker {
  int number = 0;
  Eigen::Vector2d upper_left = Eigen::Vector2d::Zero();  ///< m, in the frame of the board
};

/// Places of a board's corners and markers. Frame of the board: origin at the lower left corner of
/// the pattern as printed, x to the right, y up the page, z out of the printed side, metres.
///
/// Corner k of a chessboard, with or without markers, is the inner corner at
/// ((k % (columns - 1)) + 1, (k / (columns - 1)) + 1) squares. Corner 4 m + i of a grid of markers
/// is corner i of its marker m, clockwise from the upper left one; markers are counted by rows from
/// the lower left one, as Kalibr does.
class Board {
 public:
  /// Throws std::invalid_argument as BoardOptions::validate().
  explicit Board(const BoardOptions& options);

  const BoardOptions& options() const { return options_; }
  const std::vector<Eigen::Vector2d>& corners() const { return corners_; }
  const std::vector<BoardMarker>& markers() const { return markers_; }
  Eigen::Vector2d size() const;  ///< of the pattern, m
  Eigen::Vector2d centre() const { return size() / 2; }
  /// Whether the square in a row from the top and a column from the left has the pattern's colour.
  bool isDark(int row, int column) const;
  /// True for a plain chessboard that looks the same when it is turned by half a turn.
  bool looksSameTurned() const;

 private:
  BoardOptions options_;
  std::vector<Eigen::Vector2d> corners_;
  std::vector<BoardMarker> markers_;
};

}  // namespace markerless_mocap
