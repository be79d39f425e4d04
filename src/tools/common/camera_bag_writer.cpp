#include "tools/common/camera_bag_writer.h"

#include <sensor_msgs/CompressedImage.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <utility>

#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

void checkSize(const CameraCalibration& camera, const cv::Mat& pixels) {
  if (pixels.empty() || (pixels.cols == camera.width && pixels.rows == camera.height)) return;
  throw std::invalid_argument("an image or mask of " + camera.name + " is " +
                              std::to_string(pixels.cols) + " x " + std::to_string(pixels.rows) +
                              " pixels, the first one was " + std::to_string(camera.width) + " x " +
                              std::to_string(camera.height));
}

}  // namespace

CameraBagWriter::CameraBagWriter(const std::string& path, std::vector<CameraCalibration> cameras,
                                 int jpeg_quality, rosbag::CompressionType compression)
    : cameras_(std::move(cameras)), jpeg_quality_(jpeg_quality), bag_(path, compression) {
  for (const CameraCalibration& camera : cameras_) camera.validate();
}

void CameraBagWriter::writeTransforms(int64_t stamp_ns) {
  const ros::Time stamp = rosTime(stamp_ns);
  bag_.writeLatched("/tf_static", stamp, transformsOf(cameras_, stamp, "world"));
}

void CameraBagWriter::write(int64_t stamp_ns, size_t camera, const cv::Mat& image,
                            const cv::Mat& mask) {
  const CameraCalibration& calibration = cameras_.at(camera);
  checkSize(calibration, image);
  checkSize(calibration, mask);
  std_msgs::Header header;
  header.stamp = rosTime(stamp_ns);
  header.frame_id = opticalFrame(calibration.name);
  sensor_msgs::CameraInfo info = messageFromCalibration(calibration);
  info.header = header;
  bag_.write("/" + calibration.name + "/camera_info", header.stamp, info);
  if (!image.empty()) writeImage(calibration.name, header, image);
  if (!mask.empty())
    bag_.write("/" + calibration.name + "/silhouette", header.stamp, messageFromMat(mask, header));
}

void CameraBagWriter::writeImage(const std::string& name, const std_msgs::Header& header,
                                 const cv::Mat& image) {
  if (jpeg_quality_ == 0) {
    bag_.write("/" + name + "/image_raw", header.stamp, messageFromMat(image, header));
    return;
  }
  sensor_msgs::CompressedImage message;
  message.header = header;
  message.format = "jpeg";
  cv::imencode(".jpg", image, message.data, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality_});
  bag_.write("/" + name + "/image_raw/compressed", header.stamp, message);
}

}  // namespace markerless_mocap
