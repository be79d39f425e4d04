#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "calibration/calibrate.h"
#include "tools/calibrate_rig/film_starts.h"

namespace markerless_mocap {

/// Arguments of calibrate_rig.
struct CalibrateRigArguments {
  std::string output;                      ///< folder
  std::vector<std::string> inputs;         ///< films, as findFilms(); live: names of cameras
  bool live = false;                       ///< from image topics; ROS must be initialised
  std::function<bool()> interrupted;       ///< live: true ends the search
  std::string video;                       ///< file in each camera's folder
  std::vector<std::string> lens_pictures;  ///< films for the lenses only
  BoardOptions board;
  std::string times;  ///< table of times, or empty
  FilmStart start = FilmStart::kUnknown;
  double largest_offset = kLargestFilmOffset;  ///< s
  std::string lenses;  ///< as readLenses(): intrinsics that are kept, or empty
  std::string lens = "auto";
  std::string points;             ///< file of known points, or empty
  std::string floor;              ///< CAMERA or CAMERA:SECONDS, or empty
  double floor_thickness = 0.0;   ///< m
  std::vector<std::string> walk;  ///< films of a person who walks, as findFilms(), or empty
  bool separate = false;          ///< no two images are of one time
  bool lens_only = false;
  int most_images = 300;  ///< per film
  std::string world_frame = "world";
};

/// Reads films or watches live cameras, calibrates, writes the results.
/// \param notes progress and summary; nullptr: none
/// Throws std::runtime_error or std::invalid_argument with a sentence for people.
RigCalibration calibrateFilms(const CalibrateRigArguments& arguments, std::ostream* notes,
                              bool terminal);

/// The verdict and a table of the cameras.
void print(const RigCalibration& result, std::ostream& out);

/// What was written, and the command that uses it.
std::string nextStep(const CalibrateRigArguments& arguments);

}  // namespace markerless_mocap
