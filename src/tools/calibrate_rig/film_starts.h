#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "calibration/calibrate.h"
#include "tools/calibrate_rig/find_boards.h"

namespace markerless_mocap {

/// Searches when films began, and lets the calibration estimate it exactly if they began at
/// different times. Nothing is done about films that clearly or perhaps began together: which of
/// both is told.
/// \param input changed: estimate_offsets, clocks, largest_offset is read
/// \return sentence for people; empty: nothing to say
std::string findStarts(FilmStart start, CalibrationInput* input);

/// Images in which cameras see the board at the same times, each with its neighbours, by which the
/// motion of the board is known: the times at which several cameras saw it, evenly spread.
/// \param offsets s, to be added to the clock of each camera \param most_images of a camera
std::vector<std::vector<size_t>> imagesTogether(const FoundBoards& boards,
                                                const std::vector<double>& offsets,
                                                int most_images);

/// Whether images were passed over, so that those searched of two cameras may lie apart in time.
bool areSparse(const FoundBoards& boards);
/// Whether films of different rates were searched.
bool haveOneRate(const FoundBoards& boards);

}  // namespace markerless_mocap
