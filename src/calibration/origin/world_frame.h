#pragma once

#include <optional>

#include "calibration/adjust/rig_state.h"

namespace markerless_mocap {

/// Moves the whole rig: every pose becomes one in a new world.
void moveWorld(const Eigen::Isometry3d& new_old, RigState* state);

/// World whose floor is the board as it lay at a time: z = 0 on the board, z up out of its printed
/// side, origin and x as in the frame of the board.
/// \param camera,time the view to take, s of the camera's clock; the nearest one is taken
/// \param thickness m, of the board: the floor is so much below the pattern
/// Throws std::invalid_argument if the camera never saw the board.
void putFloorUnderBoard(size_t camera, double time, double thickness, RigState* state);

/// World without a known floor: up as the mean of the cameras' upward axes, z = 0 at the lowest
/// place where a corner of the board was seen, origin amid the places of the board.
void guessFloor(const Board& board, RigState* state);

/// Pose of each camera that sees at least four known points, by those points; empty for others.
std::vector<std::optional<Eigen::Isometry3d>> posesByPoints(const RigState& state);

/// Moves each group of joined cameras to where the known points put it; cameras without points keep
/// their place within the group. Groups in which no camera sees four points stay not located.
void placeByPoints(const std::vector<size_t>& groups, RigState* state);

}  // namespace markerless_mocap
