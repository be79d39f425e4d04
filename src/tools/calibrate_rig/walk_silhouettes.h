#pragma once

#include <vector>

#include "calibration/views.h"
#include "calibration/walk_floor.h"
#include "tools/calibrate_rig/film.h"

namespace markerless_mocap {

/// Silhouettes of whoever moves in films, by background subtraction; nobody need leave the scene.
/// Images of one time are joined: those of the camera with fewest, and the nearest of each other
/// one within half an interval.
/// \param cameras in their order silhouettes are given; a camera without a film gets none
/// \param offsets s, added to the times of each camera's images if they are of a bag or of the
/// board's
///   films: videos of another time began by themselves
/// \param of_board the films are those in which the board was seen
/// Throws std::runtime_error if fewer than two cameras have a film or an image has not its camera's
/// size.
std::vector<SilhouetteSet> walkSilhouettes(const std::vector<FilmSource>& films,
                                           const std::vector<CameraToCalibrate>& cameras,
                                           const std::vector<double>& offsets, bool of_board);

}  // namespace markerless_mocap
