#pragma once

#include <vector>

#include "calibration/start/board_pose.h"
#include "calibration/views.h"
#include "camera/film_clocks.h"

namespace markerless_mocap {

/// Searches the offsets with which the board moves alike before all cameras, up to the rigid motion
/// from one camera to another: to a fraction of the time between views.
/// \param poses of the board in each view
/// \param largest offset between two cameras that is searched for, s
FilmClocks searchOffsets(const Board& board, size_t cameras, const std::vector<BoardView>& views,
                         const std::vector<BoardPose>& poses, double largest);

}  // namespace markerless_mocap
