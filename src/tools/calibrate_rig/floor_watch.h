#pragma once

#include "calibration/board_coverage.h"

namespace markerless_mocap {

/// Whether the board lies still in a camera's image, since it moved last. Times are in seconds.
class FloorWatch {
 public:
  /// \param width of the image, pixels
  void add(double time, const BoardCorners& corners, double width) {
    constexpr double kMoves = 0.005;  // of the image's width
    if (distanceBetween(corners, last_) > kMoves * width) {
      since_ = time;
      last_ = corners;
    }
    now_ = time;
  }
  /// True if it has lain still for some time. \param from it must have come to its place later
  bool isStill(double from) const {
    constexpr double kStill = 2.0;
    return since_ > from && now_ - since_ > kStill;
  }
  double time() const { return now_; }

 private:
  BoardCorners last_;
  double since_ = 0.0, now_ = 0.0;
};

}  // namespace markerless_mocap
