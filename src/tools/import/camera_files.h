#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// A 3x4 projection matrix from a file: an OpenCV XML or YAML file that holds a 3x4 matrix, or a
/// text that has twelve numbers, row by row, outside its XML tags. Throws std::runtime_error with
/// one sentence that names the file.
Eigen::Matrix<double, 3, 4> readProjection(const std::string& path);

/// K, distortion and pose from an OpenCV calibration file with CameraMatrix, DistortionCoeffs,
/// Rotation (vector of Rodrigues or 3x3; world to camera) and Translation, in the units and axes of
/// its world. Width and height are left 0. Throws std::runtime_error naming file and entry.
CameraCalibration readCalibration(const std::string& path);

/// Files of each numbered camera, sorted by name. `%d` or `%0Nd` in the pattern stands for the
/// camera's number (0 to 999), `*`, `?` and `[...]` match as in a shell. Throws
/// std::runtime_error if the pattern has no number or matches nothing.
std::map<int, std::vector<std::string>> filesByCamera(const std::string& pattern);

}  // namespace markerless_mocap
