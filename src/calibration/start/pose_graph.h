#pragma once

#include <vector>

#include "calibration/adjust/rig_state.h"
#include "calibration/start/board_pose.h"
#include "calibration/start/spanning_tree.h"

namespace markerless_mocap {

/// Two cameras that saw the board together.
struct CameraPair {
  size_t a = 0, b = 0;
  int shared = 0;                                         ///< instants
  int agreeing = 0;                                       ///< instants whose relative poses agree
  Eigen::Isometry3d a_b = Eigen::Isometry3d::Identity();  ///< pose of b in the frame of a
};

/// Relative poses of all pairs: the mean of those poses that most others are near to.
/// \param poses of the board in each BoardView
std::vector<CameraPair> cameraPairs(const Board& board, const RigState& state,
                                    const std::vector<BoardPose>& poses);

/// Poses of all cameras over the best known pairs, then of all boards. The strongest camera of each
/// group of joined cameras is the origin of the group; only the largest group becomes `located`.
/// Boards that look the same turned are turned to agree.
/// \return the group of each camera
std::vector<size_t> placeCameras(const Board& board, const std::vector<CameraPair>& pairs,
                                 const std::vector<BoardPose>& poses, RigState* state);

/// Poses of all boards from the poses of the cameras, each by the view that shows most of it.
void placeBoards(const Board& board, const std::vector<BoardPose>& poses, RigState* state);

}  // namespace markerless_mocap
