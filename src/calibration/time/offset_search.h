#pragma once

#include <vector>

#include "calibration/start/board_pose.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// Time offsets, s, to be added to the clock of each camera, to a fraction of a frame: those with
/// which the board's centre moves alike in the frames of two cameras, up to a rigid motion. The
/// camera with most views in common with others has 0. NaN for a camera that shares too few.
/// \param poses of the board in each view
/// \param largest offset that is searched for, s
std::vector<double> searchOffsets(const Board& board, size_t cameras,
                                  const std::vector<BoardView>& views,
                                  const std::vector<BoardPose>& poses, double largest);

}  // namespace markerless_mocap
