#pragma once

#include <vector>

#include "calibration/adjust/rig_state.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// Median time between neighbouring views of a camera that were not taken alone, s; 0 if it has
/// fewer than two.
double viewInterval(const std::vector<BoardView>& views, size_t camera);

/// Velocity and acceleration of every corner of every view, from the camera's views before and
/// after. NaN where a corner is in neither.
std::vector<std::vector<CornerMotion>> cornerMotions(const std::vector<BoardView>& views,
                                                     size_t cameras);

/// Groups the views whose times belong together, each camera once, oldest first. Corners that would
/// have to be moved in time but whose motion is not known are left out.
/// \param offsets s, to be added to each camera's clock
std::vector<Instant> groupInstants(const std::vector<BoardView>& views,
                                   const std::vector<std::vector<CornerMotion>>& motions,
                                   const std::vector<double>& offsets);

/// Of a board that looks the same turned: gives each view the numbers that let the corners move
/// least since the camera's view before. \param corners of the whole board
void keepTurns(int corners, size_t cameras, std::vector<BoardView>* views);

}  // namespace markerless_mocap
