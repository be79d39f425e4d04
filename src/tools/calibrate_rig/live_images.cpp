#include "tools/calibrate_rig/live_images.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr double kSilent = 1.0;  // s after which a camera is not waited for
constexpr size_t kBuffered = 8;  // images of a camera

template <class Message>
double timeOf(const Message& message) {
  return 1e-9 * double(nanosecondsOf(message.header.stamp));
}

}  // namespace

Decoded decoded(const Arrival& arrival) {
  try {
    if (arrival.raw) return {matFromMessage(*arrival.raw), ""};
    if (arrival.compressed) return {matFromMessage(*arrival.compressed), ""};
  } catch (const std::invalid_argument& error) {
    return {{}, error.what()};
  }
  return {};
}

LiveImages::LiveImages(ros::NodeHandle& node, const std::vector<std::string>& cameras)
    : buffers_(cameras.size()) {
  for (size_t i = 0; i < cameras.size(); ++i) {
    subscribers_.push_back(node.subscribe<sensor_msgs::Image>(
        cameras[i] + "/image_raw", 2, [this, i](const sensor_msgs::Image::ConstPtr& image) {
          add(i, {timeOf(*image), image, nullptr});
        }));
    subscribers_.push_back(node.subscribe<sensor_msgs::CompressedImage>(
        cameras[i] + "/image_raw/compressed", 2,
        [this, i](const sensor_msgs::CompressedImage::ConstPtr& image) {
          add(i, {timeOf(*image), nullptr, image});
        }));
  }
}

Arrival LiveImages::newest(size_t camera) const {
  return buffers_[camera].empty() ? Arrival() : buffers_[camera].back();
}

double LiveImages::commonTime() const {
  double newest = -INFINITY, common = INFINITY;
  for (const auto& buffer : buffers_)
    if (!buffer.empty()) newest = std::max(newest, buffer.back().time);
  for (const auto& buffer : buffers_)
    if (!buffer.empty() && buffer.back().time > newest - kSilent)
      common = std::min(common, buffer.back().time);
  return common;
}

Arrival LiveImages::nearest(size_t camera, double time, double within) const {
  Arrival nearest;
  for (const Arrival& arrival : buffers_[camera])
    if (std::abs(arrival.time - time) < within &&
        (!(nearest.raw || nearest.compressed) ||
         std::abs(arrival.time - time) < std::abs(nearest.time - time)))
      nearest = arrival;
  return nearest;
}

void LiveImages::add(size_t camera, Arrival arrival) {
  std::deque<Arrival>& buffer = buffers_[camera];
  if (!buffer.empty() && arrival.time <= buffer.back().time) buffer.clear();  // time began anew
  buffer.push_back(std::move(arrival));
  if (buffer.size() > kBuffered) buffer.pop_front();
}

}  // namespace markerless_mocap
