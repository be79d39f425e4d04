#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/dnn/dnn.hpp>
#include <string>

#include "markerless_mocap/silhouette/network_options.h"

namespace markerless_mocap {

/// A network that segments people, run by OpenCV's dnn. Not thread-safe.
class PersonNet {
 public:
  /// Runs the net once on a black image. Throws std::invalid_argument with a message that names the
  /// file if it is missing or no net that OpenCV can load, if the net does not take images of the
  /// size in the options, or if its output is not as they say.
  explicit PersonNet(const NetworkOptions& options);

  /// \param image CV_8UC1 or CV_8UC3 (BGR), of any size
  /// \return CV_32FC1, image size: how probably each pixel shows a person, 0 to 1
  cv::Mat probability(const cv::Mat& image);

 private:
  void chooseOutput();
  cv::Mat inputOf(const cv::Mat& image) const;
  cv::Mat run(const cv::Mat& image);
  cv::Mat personPlane(const cv::Mat& output) const;
  [[noreturn]] void throwError(const std::string& what) const;

  NetworkOptions options_;
  cv::dnn::Net net_;
  std::string output_;  ///< name of the output that is read
};

}  // namespace markerless_mocap
