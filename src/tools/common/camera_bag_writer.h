#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "tools/common/bag_io.h"

namespace markerless_mocap {

/// Writes a recording of several cameras: camera_info, image_raw or image_raw/compressed, and
/// silhouette of each, with latched /tf_static world -> <camera>_optical.
class CameraBagWriter {
 public:
  /// \param cameras complete calibrations, metres, z up; throws std::invalid_argument if one is not
  ///   valid
  /// \param jpeg_quality 1 to 100; 0: raw images
  CameraBagWriter(const std::string& path, std::vector<CameraCalibration> cameras, int jpeg_quality,
                  rosbag::CompressionType compression = rosbag::compression::LZ4);

  /// To be called once, before the first instant.
  void writeTransforms(int64_t stamp_ns);
  /// \param image CV_8UC3 or CV_8UC1, or empty: none \param mask CV_8UC1 0 | 255, or empty: none
  ///   Throws std::invalid_argument if their size is not the camera's.
  void write(int64_t stamp_ns, size_t camera, const cv::Mat& image, const cv::Mat& mask);
  void commit() { bag_.commit(); }
  /// For what else belongs into the recording.
  BagWriter& bag() { return bag_; }

 private:
  void writeImage(const std::string& name, const std_msgs::Header& header, const cv::Mat& image);

  std::vector<CameraCalibration> cameras_;
  int jpeg_quality_;
  BagWriter bag_;
};

}  // namespace markerless_mocap
