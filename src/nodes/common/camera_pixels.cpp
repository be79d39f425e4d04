#include "nodes/common/camera_pixels.h"

#include <stdexcept>
#include <string>

#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

bool hasSizeOf(const Camera& camera, const cv::Mat& pixels) {
  return pixels.cols == camera.width() && pixels.rows == camera.height();
}

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

cv::Mat maskOfCamera(const Camera& camera, const sensor_msgs::Image& message) {
  return maskOfCamera(camera, maskFromMessage(message));
}

cv::Mat maskOfCamera(const Camera& camera, const cv::Mat& mask) {
  if (hasSizeOf(camera, mask)) return mask;
  throw std::invalid_argument("mask of camera '" + camera.name() + "' is " +
                              sizeText(mask.cols, mask.rows) + " pixels, its calibration says " +
                              sizeText(camera.width(), camera.height()));
}

cv::Mat imageOfCamera(const Camera& camera, const CameraImage& image) {
  try {
    const cv::Mat pixels = image.mat();
    if (hasSizeOf(camera, pixels)) return pixels;
  } catch (const std::exception&) {  // silhouette tells it
  }
  return cv::Mat();
}

}  // namespace markerless_mocap
