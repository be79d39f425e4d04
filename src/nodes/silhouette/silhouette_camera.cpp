#include "nodes/silhouette/silhouette_camera.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "markerless_mocap/products/silhouette_mask.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 16;  // images that wait while all cameras compute their backgrounds

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
      status_(handle, private_handle, "silhouette of " + camera),
      inputs_(handle, &status_) {
  loadBackground();
  publisher_ = handle.advertise<sensor_msgs::Image>(camera + "/silhouette", kPublisherQueue);
  inputs_.listenToImages(camera, node_options.image_transport, kQueue, StageInputs::kRequired,
                         [this](const CameraImage& image) { receive(image); });
}

void SilhouetteCamera::receive(const CameraImage& image) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const uint64_t jumps = order_.counts().time_jumps_back;
  const auto frame_sets = order_.add(0, nanosecondsOf(image.header().stamp), image);
  if (order_.counts().time_jumps_back != jumps) extractor_.reset();
  for (const auto& frame_set : frame_sets) process(frame_set.items[0]);
  status_.set("images", order_.counts().complete);
  status_.set("duplicate", order_.counts().duplicate);
  status_.set("late", order_.counts().late);
  status_.set("far in the future", order_.counts().far_future);
  status_.set("time went back", order_.counts().time_jumps_back);
}

void SilhouetteCamera::process(const CameraImage& image) {
  try {
    if (node_options_.input == "image")
      publishSilhouette(image);
    else
      publishMask(image.mat(), image);
  } catch (const std::exception& error) {  // errors of the core and of OpenCV
    status_.problem(camera_ + ": " + error.what());
  }
}

void SilhouetteCamera::publishMask(const cv::Mat& mask, const CameraImage& image) {
  if (mask.type() != CV_8UC1)
    throw std::invalid_argument("the image is not a mask, allowed is one channel");
  publishShared(publisher_, messageFromMat(maskOfThreeValues(mask), image.header()));
  status_.ok("masks are published");
}

void SilhouetteCamera::publishSilhouette(const CameraImage& image) {
  const SilhouetteResult silhouette = extractor_.update(image.mat());
  if (silhouette.state == SilhouetteState::kLearning) {
    status_.ok("learning the background, " + std::to_string(extractor_.framesLearned()) +
               " images so far");
    return;
  }
  publishShared(publisher_, messageFromMat(silhouette.mask, image.header()));
  const auto changed = uint64_t(std::lround(100 * silhouette.changed_fraction));
  const auto light = uint64_t(std::lround(100 * silhouette.light_gain));
  const auto unknown = uint64_t(std::ceil(100 * silhouette.unknown_fraction));
  status_.set("unknown pixels, per cent", unknown);
  status_.set("changed pixels, per cent", changed);
  status_.set("light, per cent of the background's", light);
  if (silhouette.state == SilhouetteState::kStale)
    status_.waiting("the background is stale: " + std::to_string(changed) +
                    " % of the image differ from it, the light is " + std::to_string(light) +
                    " % of what it was; masks are published, call learn_background");
  else if (unknown > 0)
    status_.ok("ready, masks are published; the background of " + std::to_string(unknown) +
               " % of the image has not been seen yet, as somebody stood there");
  else
    status_.ok("ready, masks are published");
}

void SilhouetteCamera::learnBackground() {
  checkInput();
  const std::lock_guard<std::mutex> lock(mutex_);
  extractor_.relearn();
}

void SilhouetteCamera::saveBackground() {
  checkInput();
  if (node_options_.background_folder.empty())
    throw std::invalid_argument("background_folder is empty, allowed is the folder to write to");
  const std::lock_guard<std::mutex> lock(mutex_);
  extractor_.saveBackground(backgroundFile());
}

void SilhouetteCamera::loadBackground() {
  const bool wanted = node_options_.input == "image" && !node_options_.background_folder.empty();
  if (wanted && std::filesystem::exists(backgroundFile()))
    extractor_.loadBackground(backgroundFile());
}

std::string SilhouetteCamera::backgroundFile() const {
  std::string name = camera_;
  std::replace(name.begin(), name.end(), '/', '_');
  return (std::filesystem::path(node_options_.background_folder) / (name + ".background")).string();
}

void SilhouetteCamera::checkInput() const {
  if (node_options_.input != "image")
    throw std::invalid_argument("the input consists of masks, which have no background");
}

}  // namespace markerless_mocap
