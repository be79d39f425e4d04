// 3x4 projection matrices P = K [R | t], one text or OpenCV file per camera, without distortion.
#include <cmath>
#include <opencv2/core.hpp>
#include <regex>
#include <sstream>

#include "formats/parts/camera_parts.h"
#include "formats/parts/opencv_storage.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

constexpr size_t kLongest = 4096;  // characters; twelve numbers are not longer
constexpr const char* kFormat = "3x4 matrices";

using Projection = Eigen::Matrix<double, 3, 4>;

std::vector<double> numbersOutsideTags(const std::string& text) {
  return numbersIn(std::regex_replace(text, std::regex("<[^>]*>"), " "));
}

Projection projectionIn(const TextFile& file) {
  if (isStorageText(file.text)) {
    const auto matrix = projectionInStorage(openStorage(file), file.path);
    if (matrix) return *matrix;
    throwFormatError(file.path, "there is no 3x4 matrix");
  }
  const std::vector<double> numbers = numbersOutsideTags(file.text);
  checkNumbers(numbers, 12, "a 3x4 matrix", file.path);
  return Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(numbers.data());
}

/// Twelve rounded numbers give square pixels a skew of some 1e-14.
void dropRoundedSkew(CameraCalibration* camera) {
  if (std::abs(camera->K(0, 1)) < 1e-9 * camera->K(0, 0)) camera->K(0, 1) = 0.0;
}

std::string matrixText(const CameraCalibration& camera) {
  distortionOfLength(camera, 0, kFormat);
  const Projection P = camera.K * camera.T_world_camera.inverse().matrix().topRows<3>();
  std::string out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) out += (c > 0 ? " " : "") + numberText(P(r, c));
    out += '\n';
  }
  return out;
}

}  // namespace

bool isMatrixText(const std::string& text) {
  if (isStorageText(text)) return storageHasProjection(text);
  return text.size() <= kLongest && numbersOutsideTags(text).size() == 12;
}

CalibrationSet readMatrixFiles(const std::vector<TextFile>& files) {
  const std::vector<std::string> names = cameraNamesOf(files);
  CalibrationSet set;
  for (size_t i = 0; i < files.size(); ++i) {
    try {
      set.cameras.push_back(decomposeProjection(projectionIn(files[i])));
    } catch (const std::invalid_argument& error) {
      const std::string what = error.what();
      if (what.rfind(files[i].path, 0) == 0) throw;
      throwFormatError(files[i].path, what);
    }
    dropRoundedSkew(&set.cameras.back());
    set.cameras.back().name = names[i];
  }
  return set;
}

std::vector<TextFile> writeMatrixFiles(const std::vector<CameraCalibration>& rig) {
  std::vector<TextFile> files;
  for (const CameraCalibration& camera : rig)
    files.push_back({fileNameOf(camera) + ".txt", matrixText(camera)});
  return files;
}

}  // namespace markerless_mocap
