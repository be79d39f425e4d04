#include "nodes/pose_fitting/color_images.h"

#include <ros/console.h>

#include <cstdlib>
#include <exception>
#include <utility>

#include "nodes/common/master_answers.h"
#include "ros/camera_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 16;                // callbacks only store messages
constexpr size_t kMaxImages = 64;              // per camera; it covers the delay of the stages
constexpr int64_t kKeep_ns = 3'000'000'000;    // subscribing anew takes time at the ROS master
constexpr int64_t kPatience_ns = 500'000'000;  // with a camera that sends no images

}  // namespace

ColorImages::ColorImages(std::vector<std::string> cameras, std::string transport,
                         StageInputs* inputs, StageStatus* status, std::function<void()> arrived)
    : cameras_(std::move(cameras)),
      transport_(std::move(transport)),
      inputs_(inputs),
      status_(status),
      arrived_(std::move(arrived)),
      demand_(cameras_.size(), kKeep_ns),
      images_(cameras_.size(), kMaxImages),
      known_to_be_color_(cameras_.size()),
      subscribers_(cameras_.size()),
      asked_ns_(cameras_.size()) {}

void ColorImages::noteMask(size_t camera, int64_t stamp_ns, bool needs_colors) {
  if (needs_colors) demand_.note(camera, stamp_ns);
  const bool needed = demand_.isNeeded(camera, stamp_ns);
  if (needed && !subscribers_[camera] && masterAnswers()) {
    asked_ns_[camera] = stamp_ns;
    subscribe(camera);
  }
  if (!needed && subscribers_[camera]) unsubscribe(camera);
}

bool ColorImages::areAwaited(size_t camera, int64_t stamp_ns) const {
  return asked_ns_[camera] && std::abs(stamp_ns - *asked_ns_[camera]) < kPatience_ns &&
         demand_.isNeeded(camera, stamp_ns);
}

bool ColorImages::mayStillCome(size_t camera, int64_t stamp_ns, int64_t tolerance_ns,
                               int64_t max_behind_ns) const {
  return demand_.isNeeded(camera, stamp_ns) &&
         images_.mayStillCome(camera, stamp_ns, tolerance_ns, max_behind_ns);
}

void ColorImages::receive(size_t camera, const CameraImage& image) {
  const int64_t stamp_ns = nanosecondsOf(image.header().stamp);
  const bool color = isColor(camera, image);
  asked_ns_[camera].reset();
  if (!demand_.isNeeded(camera, stamp_ns)) {  // masks may have stopped
    unsubscribe(camera);
    return;
  }
  if (color) images_.add(camera, stamp_ns, image);
  arrived_();
}

bool ColorImages::isColor(size_t camera, const CameraImage& image) {
  if (known_to_be_color_[camera]) return true;
  try {
    known_to_be_color_[camera] = image.mat().channels() == 3;
    if (!known_to_be_color_[camera]) demand_.noteGrey(camera);
  } catch (const std::exception&) {
    status_->count("images of " + cameras_[camera] + " that cannot be read");
  }
  return known_to_be_color_[camera];
}

void ColorImages::subscribe(size_t camera) {
  ROS_INFO_STREAM("pose fitting: the silhouettes of " << cameras_[camera]
                                                      << " do not tell all, its colours are used");
  subscribers_[camera] = inputs_->subscribeToImages(
      cameras_[camera], transport_, kQueue, StageInputs::kOptional,
      [this, camera](const CameraImage& image) { receive(camera, image); });
}

void ColorImages::unsubscribe(size_t camera) {
  subscribers_[camera].shutdown();
  subscribers_[camera] = ros::Subscriber();
}

}  // namespace markerless_mocap
