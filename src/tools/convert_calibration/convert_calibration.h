#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "markerless_mocap/formats/world_transform.h"

namespace markerless_mocap {

struct ConversionOptions {
  std::vector<std::string> inputs;  ///< files or folders, see readCalibration()
  std::string output;               ///< file or folder; empty: only tell what was read
  std::string format;               ///< of the output; empty: as its name says
  double scale_to_metres = 0.0;     ///< metres per unit; 0: as guessWorld()
  std::string up = "auto";          ///< axis that points up; auto: as guessWorld()
  std::string size;                 ///< such as 1280x720, where the input does not say it
  bool overwrite = false;           ///< replace files that exist
};

/// The rig in metres with z up, and what was found out about the input.
struct Conversion {
  CalibrationSet input;
  WorldGuess world;
  std::vector<CameraCalibration> rig;
  std::vector<std::string> written;  ///< files
  std::vector<std::string> warnings;
};

/// Reads a calibration and writes it in another format. Throws std::invalid_argument or
/// std::runtime_error as readCalibration() and writeCalibration(), and if an option is wrong.
Conversion convertCalibration(const ConversionOptions& options);

/// The cameras as they were read, units and axes, and the files written.
void print(const Conversion& conversion, std::ostream& out);

}  // namespace markerless_mocap
