#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/views.h"
#include "tools/calibrate_rig/calibrate_rig.h"
#include "tools/calibrate_rig/film.h"

namespace markerless_mocap {

/// The argument of --floor.
struct FloorPlace {
  std::string camera;
  std::optional<double> time;  ///< s; without it, the first view of the board
};

/// Throws std::invalid_argument if what follows the colon is no time.
FloorPlace floorPlaceIn(const std::string& text);

/// Which camera is named. Throws std::invalid_argument with the names that there are.
/// \param option that names it, such as "--floor"
size_t cameraNamed(const std::string& name, const std::vector<CameraToCalibrate>& cameras,
                   const std::string& option);

/// The arguments, and what the files that they name hold.
struct CheckedArguments : CalibrateRigArguments {
  explicit CheckedArguments(const CalibrateRigArguments& arguments)
      : CalibrateRigArguments(arguments) {}
  std::vector<FilmSource> board_films, walk_films, lens_films;
  std::vector<CameraCalibration> known_lenses;  ///< by camera; empty: none are given
};

/// Reads everything but the films: these take long, and a fault of the rest is said before. Throws
/// std::runtime_error or std::invalid_argument.
CheckedArguments checked(const CalibrateRigArguments& arguments);

}  // namespace markerless_mocap
