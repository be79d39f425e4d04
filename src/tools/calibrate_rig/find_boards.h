#pragma once

#include <functional>
#include <string>
#include <vector>

#include "calibration/board_detector.h"
#include "calibration/views.h"
#include "tools/calibrate_rig/film.h"
#include "tools/common/film_times.h"

namespace markerless_mocap {

/// What the films of all cameras show.
struct FoundBoards {
  std::vector<CameraToCalibrate> cameras;
  std::vector<BoardView> views;
  std::vector<int> images;                 ///< that were searched, by camera
  std::vector<std::vector<double>> times;  ///< of all images of each camera, s
};

/// Searches the films for the board, side by side.
/// \param most_images searched per film; of longer ones every second, third ... image is searched
/// \param times replace the films' own; a camera that is not named keeps its own
/// \param progress called with the part that is done, 0 to 1
/// Throws std::runtime_error if a film has no images, changes its size or has more images than
/// times.
FoundBoards findBoards(const BoardDetector& detector, const std::vector<FilmSource>& films,
                       int most_images, const FrameTimes& times,
                       const std::function<void(double)>& progress);

/// The same in given images. \param numbers of images, by film, ascending
FoundBoards findBoardsIn(const BoardDetector& detector, const std::vector<FilmSource>& films,
                         const std::vector<std::vector<size_t>>& numbers, const FrameTimes& times,
                         const std::function<void(double)>& progress);

/// Some images of a film, evenly spread.
std::vector<cv::Mat> imagesOf(const FilmSource& film, int images);

/// Adds pictures that were taken for the lenses only; their cameras must be among those found.
void addLensPictures(const FoundBoards& pictures, FoundBoards* boards);

/// Reads known points: a YAML list `points`, each with a `name`, a `position` [x, y, z] in metres
/// and `pixels`, a map of cameras to [u, v]. Throws std::runtime_error or std::invalid_argument.
std::vector<KnownPoint> readKnownPoints(const std::string& path,
                                        const std::vector<CameraToCalibrate>& cameras);

}  // namespace markerless_mocap
