#include "nodes/common/camera_image.h"

#include "ros/image_conversions.h"

namespace markerless_mocap {

cv::Mat CameraImage::mat() const {
  if (raw) return sharedMatFromMessage(*raw);
  return compressed ? matFromMessage(*compressed) : cv::Mat();
}

cv::Mat CameraImage::mat(const ReductionRule& rule, cv::Size* whole) const {
  if (compressed) return matFromMessage(*compressed, rule, whole);
  const cv::Mat image = mat();
  *whole = image.size();
  return image;
}

}  // namespace markerless_mocap
