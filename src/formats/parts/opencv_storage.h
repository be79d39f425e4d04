#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "formats/parts/layout.h"

namespace markerless_mocap {

/// Whether a text is OpenCV's XML or YAML.
bool isStorageText(const std::string& text);

/// Throws std::invalid_argument if the text is not well-formed.
cv::FileStorage openStorage(const TextFile& file);

/// Keys at the top; empty if the text is not well-formed.
std::vector<std::string> storageKeys(const std::string& text);
/// The first key of `keys` that is there; empty if none is.
std::string storageKeyAmong(const cv::FileStorage& storage, const std::vector<std::string>& keys);

/// Numbers of a matrix or a list, row by row; throws if it has other content.
std::vector<double> storageNumbers(const cv::FileStorage& storage, const std::string& key,
                                   const std::string& where);
/// One number; throws if it has other content.
double storageNumber(const cv::FileStorage& storage, const std::string& key,
                     const std::string& where);
/// The first 3x4 matrix. Throws if what is meant as a matrix is none.
std::optional<Eigen::Matrix<double, 3, 4>> projectionInStorage(const cv::FileStorage& storage,
                                                               const std::string& where);
bool storageHasProjection(const std::string& text);

/// A matrix as OpenCV stores it.
cv::Mat storageMatrix(const std::vector<double>& values, int rows);

}  // namespace markerless_mocap
