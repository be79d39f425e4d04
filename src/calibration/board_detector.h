#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "calibration/board.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// Finds a board in images by OpenCV's detectors. Immutable; may be shared by threads.
class BoardDetector {
 public:
  /// Throws std::invalid_argument as BoardOptions::validate().
  explicit BoardDetector(const Board& board);
  ~BoardDetector();

  const Board& board() const { return board_; }
  /// Corners in an image (CV_8UC1 or CV_8UC3); empty if there are fewer than six or if they lie on
  /// one line. A chessboard that looks the same turned may be found turned by half a turn.
  /// \param thorough look longer for a plain chessboard that is small or seen at a slant
  /// \param before corners in the image before, of which most boards are not far: they are found
  ///   sooner then; nullptr: not known
  std::optional<BoardCorners> detect(const cv::Mat& image, bool thorough = false,
                                     const BoardCorners* before = nullptr) const;

 private:
  struct Markers;
  Board board_;
  std::unique_ptr<Markers> markers_;  ///< null for a plain chessboard
};

}  // namespace markerless_mocap
