#include "calibration/board_hints.h"

#include <algorithm>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "calibration/board_detector.h"

namespace markerless_mocap {
namespace {

constexpr int kLeast = 3;  // markers that are no accident

/// Images in which the board is found.
int imagesWith(const BoardOptions& options, const std::vector<cv::Mat>& images) {
  const BoardDetector detector{Board(options)};
  return int(std::count_if(images.begin(), images.end(), [&](const cv::Mat& image) {
    return detector.detect(image).has_value();
  }));
}

int markersIn(const cv::Mat& image, const std::string& dictionary, const BoardOptions& options) {
  cv::Mat shown;
  if (options.inverted)
    cv::bitwise_not(image, shown);
  else
    shown = image;
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->markerBorderBits = options.border_bits;
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> numbers;
  cv::aruco::detectMarkers(shown, cv::aruco::getPredefinedDictionary(dictionaryNumber(dictionary)),
                           corners, numbers, parameters);
  return int(numbers.size());
}

struct OtherMarkers {
  std::string dictionary;
  bool inverted = false;
  int markers = 0;
};

/// The smallest dictionary of which most markers are seen: larger ones begin with its markers.
OtherMarkers otherMarkersIn(const BoardOptions& options, const std::vector<cv::Mat>& images) {
  OtherMarkers best;
  for (const bool inverted : {options.inverted, !options.inverted})
    for (const std::string& dictionary : dictionaryNames()) {
      BoardOptions other = options;
      other.inverted = inverted;
      int markers = 0;
      for (const cv::Mat& image : images) markers += markersIn(image, dictionary, other);
      if (markers > best.markers) best = {dictionary, inverted, markers};
    }
  return best;
}

}  // namespace

std::string otherBoardIn(const Board& board, const std::vector<cv::Mat>& images) {
  BoardOptions other = board.options();
  other.inverted = !other.inverted;
  if (other.kind == "chessboard") {
    other = board.options();
    ++other.columns;
    ++other.rows;
    if (imagesWith(other, images) == 0) return "";
    return "a chessboard of " + std::to_string(other.columns) + " x " + std::to_string(other.rows) +
           " squares is seen: --columns and --rows count squares, not "
           "inner corners";
  }
  if (imagesWith(other, images) > 0)
    return other.inverted ? "the board is white on black: --inverted"
                          : "the board is black on white: leave out --inverted";
  const OtherMarkers seen = otherMarkersIn(board.options(), images);
  if (seen.markers < kLeast) return "";
  return "markers of " + seen.dictionary + " are seen" +
         (seen.inverted != board.options().inverted
              ? (seen.inverted ? ", white on black: --inverted" : ", black on white")
              : "") +
         (seen.dictionary != board.options().dictionary ? ": --dictionary " + seen.dictionary
                                                        : ": are --columns and --rows right?");
}

}  // namespace markerless_mocap
