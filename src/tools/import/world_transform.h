#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// From the world of a calibration to one in metres with z up.
struct WorldTransform {
  double scale_to_metres = 1.0;  ///< metres in a unit of the calibration
  std::string up = "z";          ///< x, -x, y, -y, z or -z: axis of the calibration that points up

  /// Throws std::invalid_argument naming key, value and what is allowed.
  void validate() const;
  /// Rotation from the calibration's axes to the new ones; the shortest one, right-handed.
  Eigen::Matrix3d rotation() const;
  /// The same camera in the new world.
  CameraCalibration apply(CameraCalibration calibration) const;
};

/// Sentences about positions that look like a wrong unit or a wrong axis: cameras over 50 m or
/// under 0.2 m from each other, all cameras below the floor.
std::vector<std::string> calibrationWarnings(const std::vector<CameraCalibration>& cameras);

}  // namespace markerless_mocap
