#include "nodes/silhouette_camera.h"

#include "markerless_mocap/ros/camera_conversions.h"
#include "markerless_mocap/ros/image_conversions.h"
#include "nodes/publish_shared.h"

namespace markerless_mocap {
namespace {

AssemblerOptions singleStream() {
  AssemblerOptions options;
  options.tolerance = 0.0;
  options.min_streams = 1;
  return options;
}

}  // namespace

SilhouetteCamera::SilhouetteCamera(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                                   const std::string& camera, const SilhouetteOptions& options,
                                   const SilhouetteNodeOptions& node_options)
    : camera_(camera),
      node_options_(node_options),
      extractor_(options),
      order_(1, singleStream()),
      status_(handle, private_handle, "silhouette of " + camera) {
  topic_ = handle.resolveName(imageTopic(camera, node_options.image_transport));
  publisher_ = handle.advertise<sensor_msgs::Image>(camera + "/silhouette", 4);
  silence_timer_ = handle.createWallTimer(
      ros::WallDuration(5.0),
      gate_.guarded([this](const ros::WallTimerEvent&) { reportSilence(); }));
  subscriber_ =
      subscribeImages(handle, camera, node_options.image_transport, 4,
                      gate_.guarded([this](const CameraImage& image) { receive(image); }));
}

void SilhouetteCamera::receive(const CameraImage& image) {
  silence_timer_.stop();
  const uint64_t jumps = order_.counts().time_jumps_back;
  const auto instants = order_.add(0, nanosecondsOf(image.header().stamp), image);
  if (order_.counts().time_jumps_back != jumps) extractor_.reset();
  for (const auto& instant : instants) process(instant.items[0]);
  status_.set("images", order_.counts().complete);
  status_.set("duplicate", order_.counts().duplicate);
  status_.set("late", order_.counts().late);
  status_.set("far in the future", order_.counts().far_future);
  status_.set("time went back", order_.counts().time_jumps_back);
}

void SilhouetteCamera::process(const CameraImage& image) {
  try {
    const cv::Mat mask = maskOf(image);
    if (mask.empty()) {
      status_.good("learning the background, " + std::to_string(extractor_.framesLearned()) +
                   " images so far");
      return;
    }
    publishShared(publisher_, messageFromMat(mask, image.header()));
    status_.good("masks are published");
  } catch (const std::exception& error) {  // the core's sentences and OpenCV's own
    status_.problem(camera_ + ": " + error.what());
  }
}

cv::Mat SilhouetteCamera::maskOf(const CameraImage& image) {
  if (node_options_.input == "image") return extractor_.update(image.mat()).mask;
  const cv::Mat mat = image.mat();
  if (mat.type() != CV_8UC1)
    throw std::invalid_argument("the image is no mask, allowed is one channel");
  return mat > 0;
}

void SilhouetteCamera::reportSilence() {
  const bool compressed = node_options_.image_transport == "compressed";
  status_.waiting(
      silentTopic(topic_, compressed ? "sensor_msgs/CompressedImage" : "sensor_msgs/Image"));
}

}  // namespace markerless_mocap
