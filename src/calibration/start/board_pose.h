#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "calibration/board.h"
#include "calibration/lens.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// Pose of the board in the frame of a camera from one view, and its error.
struct BoardPose {
  Eigen::Isometry3d camera_board = Eigen::Isometry3d::Identity();
  double rms = 0.0;  ///< pixels; infinite if there is no pose
};

/// Of the two poses that a flat board may have, the one with the smaller error, refined.
BoardPose boardPose(const Board& board, const BoardCorners& corners, const Intrinsics& intrinsics,
                    LensModel lens);

}  // namespace markerless_mocap
