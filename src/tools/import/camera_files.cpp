#include "tools/import/camera_files.h"

#include <glob.h>

#include <cstdio>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/core/persistence.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tools/common/person_urdf.h"

namespace markerless_mocap {
namespace {

constexpr int kMaxCameraNumber = 999;

/// The file as OpenCV storage; empty if it is another kind of file.
std::optional<cv::FileStorage> openStorage(const std::string& path) {
  // OpenCV aborts on some texts that are not storage files, so the header is checked first.
  const std::string text = readText(path);
  const bool marked =
      text.find("opencv_storage") != std::string::npos || text.rfind("%YAML", 0) == 0;
  if (!marked) return std::nullopt;
  try {
    cv::FileStorage storage(path, cv::FileStorage::READ);
    if (storage.isOpened()) return storage;
  } catch (const cv::Exception&) {
    // Reported below like any other unreadable file.
  }
  throw std::runtime_error(path + " is not well-formed");
}

std::vector<double> numbersOutsideTags(const std::string& text) {
  std::istringstream words(std::regex_replace(text, std::regex("<[^>]*>|[,;]"), " "));
  std::vector<double> numbers;
  for (double number; words >> number;) numbers.push_back(number);
  if (!words.eof()) numbers.clear();
  return numbers;
}

cv::Mat matrixIn(const cv::FileStorage& storage, const std::string& path, const char* key) {
  cv::Mat matrix, as_double;
  storage[key] >> matrix;
  if (matrix.empty()) throw std::runtime_error(path + " has no matrix " + key);
  matrix.convertTo(as_double, CV_64F);
  if (!cv::checkRange(as_double))
    throw std::runtime_error(path + " has a value in " + key + " that is not finite");
  return as_double;
}

void checkCount(const cv::Mat& matrix, size_t wanted, const std::string& path, const char* key) {
  if (matrix.total() != wanted)
    throw std::runtime_error(path + " has " + std::to_string(matrix.total()) + " numbers in " +
                             key + ", expected are " + std::to_string(wanted));
}

cv::Matx33d rotationIn(const cv::FileStorage& storage, const std::string& path) {
  cv::Mat rotation = matrixIn(storage, path, "Rotation");
  if (rotation.total() == 3) {
    cv::Matx33d matrix;
    cv::Rodrigues(rotation.reshape(1, 3), matrix);
    return matrix;
  }
  checkCount(rotation, 9, path, "Rotation");
  return rotation.reshape(1, 3);
}

std::string withNumber(const std::smatch& conversion, int number) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "%0*d",
                conversion[1].length() ? std::stoi(conversion[1]) : 1, number);
  return conversion.prefix().str() + digits + conversion.suffix().str();
}

std::vector<std::string> filesMatching(const std::string& pattern) {
  glob_t found{};
  std::vector<std::string> files;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return files;
}

}  // namespace

Eigen::Matrix<double, 3, 4> readProjection(const std::string& path) {
  if (const auto storage = openStorage(path)) {
    for (const cv::FileNode& node : storage->root()) {
      if (!node.isMap()) continue;
      cv::Mat matrix;
      node >> matrix;
      if (matrix.rows != 3 || matrix.cols != 4) continue;
      Eigen::Matrix<double, 3, 4> projection;
      cv::cv2eigen(matrix, projection);
      return projection;
    }
    throw std::runtime_error(path + " has no 3x4 matrix");
  }
  const std::vector<double> numbers = numbersOutsideTags(readText(path));
  if (numbers.size() != 12)
    throw std::runtime_error(path + " does not hold the twelve numbers of a 3x4 matrix");
  return Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(numbers.data());
}

CameraCalibration readCalibration(const std::string& path) {
  const auto storage = openStorage(path);
  if (!storage) throw std::runtime_error(path + " is not an OpenCV calibration file");
  const cv::Mat K = matrixIn(*storage, path, "CameraMatrix");
  const cv::Mat D = matrixIn(*storage, path, "DistortionCoeffs").reshape(1, 1);
  const cv::Mat t = matrixIn(*storage, path, "Translation").reshape(1, 1);
  checkCount(K, 9, path, "CameraMatrix");
  checkCount(t, 3, path, "Translation");

  CameraCalibration calibration;
  cv::cv2eigen(K.reshape(1, 3), calibration.K);
  calibration.D.assign(D.begin<double>(), D.end<double>());
  Eigen::Isometry3d T_camera_world = Eigen::Isometry3d::Identity();
  Eigen::Matrix3d rotation;
  cv::cv2eigen(rotationIn(*storage, path), rotation);
  T_camera_world.linear() = rotation;
  T_camera_world.translation() = Eigen::Vector3d(t.at<double>(0), t.at<double>(1), t.at<double>(2));
  calibration.T_world_camera = T_camera_world.inverse();
  return calibration;
}

std::map<int, std::vector<std::string>> filesByCamera(const std::string& pattern) {
  static const std::regex kNumber("%0?([0-9]?)d");
  std::smatch conversion;
  if (!std::regex_search(pattern, conversion, kNumber))
    throw std::runtime_error("the pattern " + pattern +
                             " has no %d or %02d for the number of the camera");
  std::map<int, std::vector<std::string>> files;
  for (int number = 0; number <= kMaxCameraNumber; ++number) {
    const auto found = filesMatching(withNumber(conversion, number));
    if (!found.empty()) files[number] = found;
  }
  if (files.empty()) throw std::runtime_error("no file matches " + pattern);
  return files;
}

}  // namespace markerless_mocap
