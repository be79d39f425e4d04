#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <thread>

#include "ros/node_options.h"

namespace markerless_mocap {

/// One USB camera, or a video file in its place, read by a thread of its own.
class CameraSource {
 public:
  /// Called by the thread. \param stamp_ns when the image was taken
  using Sink = std::function<void(int64_t stamp_ns, const cv::Mat& image)>;
  /// Called by the thread when no image comes. \param reason a sentence
  using Trouble = std::function<void(const std::string& reason)>;

  /// \param source device such as /dev/video0, its number, or a video file
  /// Throws std::runtime_error if it cannot be opened.
  CameraSource(std::string name, std::string source, const UsbCameraOptions& options);
  ~CameraSource();
  CameraSource(const CameraSource&) = delete;
  CameraSource& operator=(const CameraSource&) = delete;

  /// \param start_ns stamp of the first image of a video file
  void start(int64_t start_ns, Sink sink, Trouble trouble);
  bool isDevice() const { return device_; }

 private:
  bool open();
  void run();
  void readDevice();
  /// Returns whether the file had images.
  bool readFile();
  /// Returns false if the thread shall end.
  bool waitUntil(int64_t stamp_ns) const;

  std::string name_, source_;
  UsbCameraOptions options_;
  bool device_;
  int64_t start_ns_ = 0;
  cv::VideoCapture capture_;
  Sink sink_;
  Trouble trouble_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace markerless_mocap
