#pragma once

#include <string>
#include <vector>

#include "calibration/calibrate.h"
#include "tools/calibrate_rig/film.h"
#include "tools/calibrate_rig/find_boards.h"

namespace markerless_mocap {

/// Whether all cameras see the board and it lies still.
bool liesStill(const Board& board, const FoundBoards& boards);

/// If the board lies still in all films: one view of each camera is left, clocks are not asked, and
/// how a board lies that looks the same turned is told by the floor around it.
/// \param remark for people, or left as it is
/// \return whether it lies still
/// Throws std::invalid_argument if the lenses are not given.
bool useStillBoard(const std::vector<FilmSource>& films, CalibrationInput* input,
                   std::string* remark);

}  // namespace markerless_mocap
