#include "formats/parts/opencv_storage.h"

#include <cmath>

#include "formats/parts/camera_parts.h"

namespace markerless_mocap {
namespace {

bool isMatrix(const cv::FileNode& node) {
  return node.isMap() && !node["rows"].empty() && !node["cols"].empty() && !node["data"].empty();
}

/// Throws std::invalid_argument if what is meant as a matrix is none: OpenCV would stop at it with
/// a sentence about its own code.
std::optional<cv::Mat> matrixIn(const cv::FileNode& node, const std::string& where) {
  if (!isMatrix(node)) return std::nullopt;
  cv::Mat matrix, as_double;
  try {
    node >> matrix;
    matrix.convertTo(as_double, CV_64F);
  } catch (const cv::Exception&) {
    throwFormatError(where, "'" + node.name() +
                                "' is no matrix: allowed are rows, cols, dt d or f, and data with "
                                "rows x cols numbers");
  }
  return as_double;
}

}  // namespace

bool isStorageText(const std::string& text) {
  // OpenCV aborts on some texts that are not storage files, so the header is checked first.
  return text.find("<opencv_storage") != std::string::npos || text.rfind("%YAML", 0) == 0;
}

cv::FileStorage openStorage(const TextFile& file) {
  try {
    cv::FileStorage storage(file.text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    if (storage.isOpened()) return storage;
  } catch (const cv::Exception&) {
    // Reported below like any other unreadable text.
  }
  throwFormatError(file.path, "this is not well-formed OpenCV XML or YAML");
}

std::vector<std::string> storageKeys(const std::string& text) {
  std::vector<std::string> keys;
  try {
    const cv::FileStorage storage = openStorage({"", text});
    for (const cv::FileNode& node : storage.root()) keys.push_back(node.name());
  } catch (const std::invalid_argument&) {
    keys.clear();
  }
  return keys;
}

std::string storageKeyAmong(const cv::FileStorage& storage, const std::vector<std::string>& keys) {
  for (const std::string& key : keys)
    if (!storage[key].empty()) return key;
  return "";
}

std::vector<double> storageNumbers(const cv::FileStorage& storage, const std::string& key,
                                   const std::string& where) {
  const cv::FileNode node = storage[key];
  if (node.isSeq()) {
    std::vector<double> values;
    for (const cv::FileNode& entry : node)
      values.push_back(entry.isReal() || entry.isInt() ? entry.real() : std::nan(""));
    checkNumbers(values, values.size(), "'" + key + "'", where);
    return values;
  }
  const auto matrix = matrixIn(node, where);
  if (!matrix || matrix->empty()) throwFormatError(where, "there is no matrix '" + key + "'");
  const cv::Mat row = matrix->reshape(1, 1);
  std::vector<double> values(row.begin<double>(), row.end<double>());
  checkNumbers(values, values.size(), "'" + key + "'", where);
  return values;
}

double storageNumber(const cv::FileStorage& storage, const std::string& key,
                     const std::string& where) {
  const cv::FileNode node = storage[key];
  if (!node.isReal() && !node.isInt())
    throwFormatError(where, "'" + key + "' is no number, allowed is one");
  return node.real();
}

std::optional<Eigen::Matrix<double, 3, 4>> projectionInStorage(const cv::FileStorage& storage,
                                                               const std::string& where) {
  for (const cv::FileNode& node : storage.root()) {
    const auto matrix = matrixIn(node, where);
    if (!matrix || matrix->rows != 3 || matrix->cols != 4) continue;
    return Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(matrix->ptr<double>());
  }
  return std::nullopt;
}

bool storageHasProjection(const std::string& text) {
  try {
    return bool(projectionInStorage(openStorage({"", text}), ""));
  } catch (const std::exception&) {
    return false;
  }
}

cv::Mat storageMatrix(const std::vector<double>& values, int rows) {
  return cv::Mat(values, true).reshape(1, rows);
}

}  // namespace markerless_mocap
