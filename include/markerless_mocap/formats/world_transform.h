#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/formats/calibration_files.h"

namespace markerless_mocap {

/// Transform from the world of a calibration to a world in metres with z up.
struct WorldTransform {
  double scale_to_metres = 1.0;  ///< metres per unit of the calibration
  std::string up = "z";          ///< x, -x, y, -y, z or -z: axis of the calibration that points up

  /// Throws std::invalid_argument; the message names key, value and allowed values.
  void validate() const;
  /// Shortest rotation from the axes of the calibration to the new ones.
  Eigen::Matrix3d rotation() const;
  /// The same camera in the new world.
  CameraCalibration apply(CameraCalibration calibration) const;
};

/// Unit and axes that a calibration seems to have, and why.
struct WorldGuess {
  WorldTransform world;
  std::string unit_reason, up_reason;
};

/// The unit is that of the format. Where the format leaves it open, it is millimetres if two
/// cameras are more than 100 units apart, else metres. Up is the axis closest to the mean of the
/// directions that are up in the images, or z if none of them is close.
WorldGuess guessWorld(const CalibrationSet& set);

/// Warnings about positions that indicate a wrong unit or axis: cameras more than 50 m or less than
/// 0.2 m apart, or all cameras below the floor.
std::vector<std::string> calibrationWarnings(const std::vector<CameraCalibration>& cameras);

}  // namespace markerless_mocap
