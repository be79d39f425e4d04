#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "calibration/board_coverage.h"
#include "calibration/board_detector.h"
#include "tools/calibrate_rig/find_boards.h"

namespace markerless_mocap {

/// What is watched, and until when.
struct LiveWatch {
  std::vector<std::string> cameras;
  CoverageGoals goals;
  std::optional<size_t> floor;  ///< camera: at the end, the board is to lie on the floor before it
  std::function<bool()> interrupted;  ///< true: use what there is
};

/// What was seen, and when the board lay on the floor.
struct LiveBoards {
  FoundBoards boards;
  std::optional<double> floor_time;  ///< s, clock of the camera LiveWatch::floor
};

/// Searches the images <camera>/image_raw (or image_raw/compressed) for the board until the views
/// suffice, and says every two seconds what is missing. Publishes the images with the cells that
/// were met in green: calibrate_rig/coverage. ROS must be initialised. Throws std::runtime_error if
/// it is interrupted before every camera had an image.
LiveBoards watchBoards(const BoardDetector& detector, const LiveWatch& watch, std::ostream* notes);

}  // namespace markerless_mocap
