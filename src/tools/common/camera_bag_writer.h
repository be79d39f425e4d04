#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "tools/common/bag_io.h"

namespace markerless_mocap {

/// A latched std_msgs/Empty on it says that all stamps are times of capture by one clock: cameras
/// that are not in step are joined, however many of them are.
constexpr char kStampsOfCapture[] = "/stamps_of_capture";

/// Writes a recording of several cameras: camera_info, image_raw or image_raw/compressed, and
/// silhouette of each camera, with latched /tf_static world -> <camera>_optical.
class CameraBagWriter {
 public:
  /// \param cameras complete calibrations, metres, z up; throws std::invalid_argument if one is
  ///   invalid
  /// \param jpeg_quality 1 to 100; 0: raw images
  CameraBagWriter(const std::string& path, std::vector<CameraCalibration> cameras, int jpeg_quality,
                  rosbag::CompressionType compression = rosbag::compression::LZ4);

  /// Call this once, before the first frame set.
  void writeTransforms(int64_t stamp_ns);
  /// \param image CV_8UC3 or CV_8UC1; empty: none
  /// \param mask CV_8UC1 0 | 128 unknown | 255; empty: none
  /// Throws std::invalid_argument if image or mask differ in size from the camera's first image.
  void write(int64_t stamp_ns, size_t camera, const cv::Mat& image, const cv::Mat& mask);
  void commit() { bag_.commit(); }
  /// For additional topics.
  BagWriter& bag() { return bag_; }

 private:
  void writeImage(const std::string& name, const std_msgs::Header& header, const cv::Mat& image);

  std::vector<CameraCalibration> cameras_;
  int jpeg_quality_;
  BagWriter bag_;
};

}  // namespace markerless_mocap
