#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Reads a 3x4 projection matrix: an OpenCV XML or YAML file that contains a 3x4 matrix, or a text
/// with twelve numbers, row by row, outside of XML tags. Throws std::runtime_error; the message
/// names the file.
Eigen::Matrix<double, 3, 4> readProjection(const std::string& path);

/// Reads K, distortion and pose from an OpenCV calibration file with CameraMatrix,
/// DistortionCoeffs, Rotation (rotation vector or 3x3; world to camera) and Translation, in the
/// units and axes of its world. Width and height stay 0. Throws std::runtime_error; the message
/// names the file and the entry.
CameraCalibration readCalibration(const std::string& path);

/// Files of each numbered camera, sorted by name. `%d` or `%0Nd` in the pattern stands for the
/// number of the camera (0 to 999); `*`, `?` and `[...]` match as in a shell. Throws
/// std::runtime_error if the pattern has no number or matches no file.
std::map<int, std::vector<std::string>> filesByCamera(const std::string& pattern);

}  // namespace markerless_mocap
