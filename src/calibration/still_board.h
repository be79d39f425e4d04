#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "calibration/board.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// A board that lies still before all cameras, as one on the floor, is one view of each, however
/// often it was filmed: they are replaced by their mean. Views that were taken alone stay.
/// \param looks_same_turned each view may be turned by half a turn; they are made alike
/// \return whether it lies still; if not, nothing is changed
bool mergeStillViews(size_t corners, bool looks_same_turned, std::vector<BoardView>* views);

/// Which way round each camera sees a board that looks the same when it is turned, by what lies
/// around it: seen from straight above the board, the floor must look alike to all cameras.
struct FloorTurns {
  std::vector<bool> turned;  ///< by view
  double certainty = 0.0;    ///< standard deviations between this and the second best; 0: no idea
};
constexpr double kCertainTurns = 4.0;  ///< from which FloorTurns are believed

/// \param views one of each camera, of all of the board
/// \param images in which they were found, CV_8UC1 or CV_8UC3
FloorTurns turnsByFloor(const Board& board, const std::vector<CameraToCalibrate>& cameras,
                        const std::vector<BoardView>& views, const std::vector<cv::Mat>& images);

}  // namespace markerless_mocap
