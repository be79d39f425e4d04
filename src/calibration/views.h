#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calibration/board.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Corners of the board in one image.
struct BoardCorners {
  std::vector<int> ids;                 ///< as Board::corners(), ascending
  std::vector<Eigen::Vector2d> pixels;  ///< pixel centres have integer coordinates
};

/// One image in which the board was found.
struct BoardView {
  size_t camera = 0;
  double time = 0.0;   ///< s, clock of the camera
  bool alone = false;  ///< a picture for the lens only: no other camera saw this instant
  BoardCorners corners;
};

/// A camera to calibrate.
struct CameraToCalibrate {
  std::string name;
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  /// Given intrinsics, which are kept; empty: they are estimated.
  std::optional<CameraCalibration> given;
};

/// A point of the world that cameras see.
struct KnownPoint {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< m, world
  std::vector<std::pair<size_t, Eigen::Vector2d>> pixels;  ///< camera and pixel
  /// Pixels, standard deviation of one coordinate of its pixels; 0: estimated, for all such points
  /// together.
  double sigma = 0.0;
};

}  // namespace markerless_mocap
