#pragma once

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace markerless_mocap {

/// The marks of one instant.
struct MarkedFrame {
  double time_s = 0.0;  ///< after `start_s`
  /// By the name of the point and of the camera, pixels.
  std::map<std::string, std::map<std::string, Eigen::Vector2d>> points;
};

/// Marks that somebody set by hand in the images of a recording.
struct MarksFile {
  double start_s = NAN;   ///< stamp of time 0, s; NaN: the first frame of the results
  double sigma_px = 5.0;  ///< standard deviation of a mark
  std::vector<MarkedFrame> frames;
};

/// Reads a file of marks. docs/report.md describes it. Throws std::runtime_error if
/// it cannot be read, std::invalid_argument with the file, the place and what is allowed.
MarksFile readMarks(const std::string& path);

}  // namespace markerless_mocap
