#include "nodes/usb_cameras/usb_camera_stage.h"

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include "markerless_mocap/camera/rig_file.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kDelay = 200'000'000;  // ns, until video files start together

}  // namespace

UsbCameraStage::UsbCameraStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                               const UsbCameraOptions& options)
    : options_(options), status_(handle, private_handle, "usb cameras") {
  if (!options_.rig_file.empty()) readRigFile();
  for (size_t i = 0; i < options_.cameras.size(); ++i) {
    const std::string& name = options_.cameras[i];
    images_.push_back(handle.advertise<sensor_msgs::Image>(name + "/image_raw", kPublisherQueue));
    if (!rig_.empty())
      infos_.push_back(
          handle.advertise<sensor_msgs::CameraInfo>(name + "/camera_info", kPublisherQueue));
    sources_.push_back(std::make_unique<CameraSource>(name, options_.sources[i], options_));
  }
  timer_ = handle.createWallTimer(
      ros::WallDuration(0.1),
      gate_.guarded([this](const ros::WallTimerEvent&) { startWhenAwaited(); }));
}

bool UsbCameraStage::isAwaited() const {
  for (size_t i = 0; i < sources_.size(); ++i)
    if (!sources_[i]->isDevice() && images_[i].getNumSubscribers() == 0) return false;
  return true;
}

void UsbCameraStage::startWhenAwaited() {
  if (!isAwaited()) return status_.waiting("video files wait until all images are subscribed to");
  timer_.stop();
  const ros::WallTime now = ros::WallTime::now();
  const int64_t start_ns = int64_t(now.sec) * 1'000'000'000 + now.nsec + kDelay;
  for (size_t i = 0; i < sources_.size(); ++i)
    sources_[i]->start(
        start_ns,
        [this, i](int64_t stamp_ns, const cv::Mat& image) { publish(i, stamp_ns, image); },
        [this](const std::string& reason) { status_.problem(reason); });
}

void UsbCameraStage::readRigFile() {
  rig_ = camerasNamed(options_.cameras, readRig(options_.rig_file), options_.rig_file);
  broadcaster_.sendTransform(transformsOf(rig_, ros::Time(0), options_.world_frame).transforms);
}

std::string UsbCameraStage::faultOf(size_t camera, const cv::Mat& image) const {
  if (rig_.empty() || (image.cols == rig_[camera].width && image.rows == rig_[camera].height))
    return "";
  return "the images of " + options_.cameras[camera] + " are " + std::to_string(image.cols) +
         " x " + std::to_string(image.rows) + " pixels, the rig " + options_.rig_file + " has " +
         std::to_string(rig_[camera].width) + " x " + std::to_string(rig_[camera].height);
}

void UsbCameraStage::publish(size_t camera, int64_t stamp_ns, const cv::Mat& image) {
  const std::string fault = faultOf(camera, image);
  if (!fault.empty()) return status_.problem(fault);
  std_msgs::Header header;
  header.stamp = rosTime(stamp_ns);
  header.frame_id = opticalFrame(options_.cameras[camera]);
  if (!rig_.empty()) {
    sensor_msgs::CameraInfo info = messageFromCalibration(rig_[camera]);
    info.header = header;
    publishShared(infos_[camera], std::move(info));
  }
  publishShared(images_[camera], messageFromMat(image, header));
  status_.count("images of " + options_.cameras[camera]);
  status_.ok("images are published");
}

}  // namespace markerless_mocap
