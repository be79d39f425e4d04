#include "calibration/board_detector.h"

#include <Eigen/Eigenvalues>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "calibration/board/chessboard_corners.h"
#include "calibration/board/marker_corners.h"

namespace markerless_mocap {
namespace {

/// Smallest standard deviation over all directions, m.
double spread(const Board& board, const std::vector<int>& ids) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const int id : ids) mean += board.corners()[id] / double(ids.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const int id : ids) {
    const Eigen::Vector2d d = board.corners()[id] - mean;
    scatter += d * d.transpose() / double(ids.size());
  }
  return std::sqrt(
      std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvalues()[0]));
}

cv::Mat darkPattern(const cv::Mat& image, bool inverted) {
  cv::Mat grey;
  if (image.type() == CV_8UC1)
    grey = image;
  else if (image.type() == CV_8UC3)
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  else
    throw std::invalid_argument("board: an image must be CV_8UC1 or CV_8UC3");
  if (!inverted) return grey;
  cv::Mat turned;
  cv::bitwise_not(grey, turned);
  return turned;
}

}  // namespace

struct BoardDetector::Markers {
  cv::Ptr<cv::aruco::Dictionary> dictionary;
};

BoardDetector::BoardDetector(const Board& board) : board_(board) {
  if (board.options().kind == "chessboard") return;
  const int number = dictionaryNumber(board.options().dictionary);
  markers_ = std::make_unique<Markers>(Markers{cv::aruco::getPredefinedDictionary(number)});
}

BoardDetector::~BoardDetector() = default;

std::optional<BoardCorners> BoardDetector::detect(const cv::Mat& image, bool thorough,
                                                  const BoardCorners* before) const {
  constexpr size_t kLeast = 6;
  const cv::Mat grey = darkPattern(image, board_.options().inverted);
  BoardCorners corners;
  if (!markers_) {
    corners = chessboardCorners(board_, grey, thorough, before);
  } else {
    const FoundMarkers markers = findMarkers(board_, markers_->dictionary, grey, before);
    corners = board_.options().kind == "markers" ? refinedMarkerCorners(markers, grey)
                                                 : cornersBetweenMarkers(board_, markers, grey);
  }
  const double least_spread = 0.3 * (markers_ ? board_.options().marker : board_.options().square);
  if (corners.ids.size() < kLeast || spread(board_, corners.ids) < least_spread)
    return std::nullopt;
  return corners;
}

}  // namespace markerless_mocap
