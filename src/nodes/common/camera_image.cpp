#include "nodes/common/camera_image.h"

#include "ros/image_conversions.h"

namespace markerless_mocap {

cv::Mat CameraImage::mat() const {
  if (raw) return sharedMatFromMessage(*raw);
  return compressed ? matFromMessage(*compressed) : cv::Mat();
}

}  // namespace markerless_mocap
