#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "formats/parts/layout.h"

namespace markerless_mocap {

/// Throws std::invalid_argument "where: what".
[[noreturn]] void throwFormatError(const std::string& where, const std::string& what);

/// \param values row by row
/// Throws if they are not nine finite numbers of a matrix fx skew cx 0 fy cy 0 0 1.
Eigen::Matrix3d cameraMatrixFrom(const std::vector<double>& values, const std::string& where);

/// The nearest rotation to a matrix (three rows of three) or that of a rotation vector (three
/// numbers, radians). Throws if a matrix is further from a rotation than rounded digits explain.
Eigen::Matrix3d rotationFrom(const std::vector<double>& values, const std::string& where);

/// Rotation vector, radians.
Eigen::Vector3d rotationVector(const Eigen::Matrix3d& rotation);

/// The camera's pose from the transform of world points to camera points.
Eigen::Isometry3d poseFromWorldToCamera(const Eigen::Matrix3d& rotation,
                                        const Eigen::Vector3d& translation);

/// Throws unless there are `wanted` finite numbers. \param what such as "translation"
void checkNumbers(const std::vector<double>& values, size_t wanted, const std::string& what,
                  const std::string& where);

/// A side of an image; throws unless it is a whole number from 1 to 65536.
int pixelsFrom(double value, const std::string& key, const std::string& where);

/// The lens as 4, 5 or 8 coefficients of OpenCV; trailing zeros beyond `wanted` are dropped. Throws
/// if the lens has more, or is a fisheye.
std::vector<double> distortionOfLength(const CameraCalibration& camera, size_t wanted,
                                       const char* format);
/// Throws if a lens is a fisheye, which the format cannot hold.
void checkNoFisheye(const CameraCalibration& camera, const char* format);
/// The four coefficients of a fisheye.
std::vector<double> fisheyeDistortion(const CameraCalibration& camera);
/// Throws if the camera has skew, which the format cannot hold.
void checkNoSkew(const CameraCalibration& camera, const char* format);

/// Numbers between blanks, commas or semicolons; empty if there is anything else.
std::vector<double> numbersIn(const std::string& text);

/// Whether a file of one camera is named after it, or, if all files of several folders have one
/// name, its folder: the names in the order of the files.
std::vector<std::string> cameraNamesOf(const std::vector<TextFile>& files);

/// Name as a file name: slashes become dashes.
std::string fileNameOf(const CameraCalibration& camera);

/// Rows of a matrix as one list.
template <class Matrix>
std::vector<double> rowsOf(const Matrix& matrix) {
  std::vector<double> values;
  for (Eigen::Index r = 0; r < matrix.rows(); ++r)
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) values.push_back(matrix(r, c));
  return values;
}

}  // namespace markerless_mocap
