#include "nodes/silhouette/silhouette_camera.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "markerless_mocap/products/silhouette_mask.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "ros/mask_png.h"

namespace markerless_mocap {
namespace {

/// Fraction of an image that has changed when somebody is there.
constexpr double kSomebody = 0.005;
constexpr int kDuplicatesTold = 5;  // images in a row
constexpr uint32_t kQueue = 16;     // images; see LoadShedding for how long they wait

bool isSame(const CameraImage& a, const CameraImage& b) {
  if (a.raw && b.raw)
    return a.raw->width == b.raw->width && a.raw->encoding == b.raw->encoding &&
           a.raw->data == b.raw->data;
  return a.compressed && b.compressed && a.compressed->data == b.compressed->data;
}

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f s", value);
  return text;
}

}  // namespace

SilhouetteCamera::SilhouetteCamera(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                                   size_t camera, const SilhouetteOptions& options,
                                   const SilhouetteNodeOptions& node_options, Shared* shared)
    : number_(camera),
      camera_(node_options.cameras.at(camera)),
      shared_(shared),
      background_frames_(options.background_frames),
      node_options_(node_options),
      extractor_(options),
      status_(handle, private_handle, "silhouette of " + camera_),
      background_(camera_, node_options, &extractor_, &status_),
      inputs_(handle, &status_) {
  extractor_.learnBeside();
  publisher_ = handle.advertise<sensor_msgs::Image>(camera_ + "/silhouette", kPublisherQueue);
  compressed_publisher_ = handle.advertise<sensor_msgs::CompressedImage>(
      camera_ + "/silhouette/compressed", kPublisherQueue);
  const std::lock_guard<std::mutex> lock(mutex_);  // images may come at once
  inputs_.listenToImages(camera_, node_options.image_transport, kQueue, StageInputs::kRequired,
                         [this](const CameraImage& image) { receive(image); });
}

void SilhouetteCamera::receive(const CameraImage& image) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!isUsable(image) || isLeftOut(image)) return;
  followSettings(image.header().stamp);
  process(image);
}

bool SilhouetteCamera::isLeftOut(const CameraImage& image) {
  const double waited_s = ros::Time::now().toSec() - image.received.toSec();
  const bool admitted = shared_->load.admits(number_, nanosecondsOf(image.header().stamp), waited_s,
                                             ros::SteadyTime::now().toSec());
  if (admitted || needs_each_image_) return false;
  status_.count("images left out, as others waited");
  return true;
}

void SilhouetteCamera::followSettings(const ros::Time& stamp) {
  const Settings::Pointer settings = shared_->settings.at(number_, nanosecondsOf(stamp));
  if (settings == used_) return;
  extractor_.change(*settings);
  used_ = settings;
}

bool SilhouetteCamera::isUsable(const CameraImage& image) {
  if (!isInOrder(image.header().stamp)) return false;
  status_.count("images");
  return node_options_.input != "image" || !isFrozen(image);
}

// The background has nothing to do with the clock: it stays when the clock is set.
bool SilhouetteCamera::isInOrder(const ros::Time& stamp) {
  using Verdict = StampOrder::Verdict;
  const StampOrder::Judgement found =
      order_.judge(nanosecondsOf(stamp), int64_t(ros::SteadyTime::now().toNSec()));
  if (found.verdict == Verdict::kZero)
    status_.error(
        "the stamps of " + camera_ + "'s images are zero, its driver has to set them" +
        (ros::Time::isSimTime() ? ", and /clock has to run, as /use_sim_time is true" : ""));
  if (found.verdict == Verdict::kDuplicate) reportDuplicate();
  if (found.verdict == Verdict::kDoubtful) status_.count("stamps out of order, or too far ahead");
  if (found.verdict == Verdict::kStepped) {
    status_.count("steps of the clock");
    status_.remark("the clock of " + camera_ + " was set " +
                   (found.step < 0 ? "back by " : "ahead by ") + seconds(std::abs(found.step)) +
                   ", its background is kept");
  }
  return found.isUsable();
}

void SilhouetteCamera::reportDuplicate() {
  status_.count("duplicate");
  if (order_.duplicates() < kDuplicatesTold) return;
  status_.problem(
      "the last " + std::to_string(order_.duplicates()) + " images of " + camera_ +
      " have the same stamp, its driver has to set the time of each image" +
      (ros::Time::isSimTime() ? ", and /clock has to go on, as /use_sim_time is true" : ""));
}

bool SilhouetteCamera::isFrozen(const CameraImage& image) {
  const bool frozen = frozen_.add(last_image_ && isSame(image, last_image_));
  last_image_ = image;
  if (!frozen) return false;
  status_.count("images of a frozen camera");
  status_.problem(camera_ + " is frozen: its last " + std::to_string(frozen_.run()) +
                  " images are all the same; no masks are published until they change");
  return true;
}

void SilhouetteCamera::process(const CameraImage& image) {
  try {
    if (node_options_.input == "image")
      publishSilhouette(image);
    else
      publishMask(image.mat(), image);
  } catch (const std::exception& error) {  // errors of the core and of OpenCV
    change_.interrupt();
    status_.count("images that cannot be used");
    status_.problem(camera_ + ": " + error.what());
    status_.remark(camera_ + " has sent images that cannot be used: " + error.what());
  }
}

void SilhouetteCamera::publishMask(const cv::Mat& mask, const CameraImage& image) {
  if (mask.type() != CV_8UC1)
    throw std::invalid_argument("the image is not a mask, allowed is one channel");
  publish(maskOfThreeValues(mask), image.header());
  status_.ok("masks are published");
}

void SilhouetteCamera::publishSilhouette(const CameraImage& image) {
  cv::Size whole;
  const cv::Mat pixels =
      image.mat([this](const cv::Size& size) { return extractor_.reductionFor(size); }, &whole);
  if (change_.add(pixels)) {
    status_.count("images unlike those before");
    return status_.problem("the last image of " + camera_ +
                           " is nearly everywhere unlike the one " +
                           "before; it is left out, unless the change stays");
  }
  const std::optional<SilhouetteResult> silhouette = background_.update(pixels, whole);
  if (!silhouette) return status_.waiting("learning the background anew");
  const CameraPhase phase = phaseAfter(*silhouette);
  needs_each_image_ = phase == CameraPhase::kCollecting;
  if (phase != CameraPhase::kReady) has_seen_somebody_ = false;
  if (!shared_->first_masks.mayPublish(number_, nanosecondsOf(image.header().stamp), phase,
                                       ros::SteadyTime::now().toSec()))
    return reportLearning();
  publish(silhouette->mask, image.header());
  reportSilhouette(*silhouette);
}

CameraPhase SilhouetteCamera::phaseAfter(const SilhouetteResult& silhouette) const {
  if (silhouette.state != SilhouetteState::kLearning) return CameraPhase::kReady;
  return extractor_.framesLearned() < background_frames_ ? CameraPhase::kCollecting
                                                         : CameraPhase::kLearning;
}

void SilhouetteCamera::publish(const cv::Mat& mask, const std_msgs::Header& header) {
  if (compressed_publisher_.getNumSubscribers() > 0)
    publishShared(compressed_publisher_, compressedMask(mask, header));
  publishShared(publisher_, messageFromMat(mask, header));
  status_.sent(header.stamp);
}

void SilhouetteCamera::reportLearning() {
  const std::string images = std::to_string(extractor_.framesLearned()) + " images so far";
  if (!has_been_ready_) return status_.ok("learning the background, " + images);
  status_.waiting("learning the background again, " + images +
                  "; no masks are published meanwhile, keep out of view if you can");
}

void SilhouetteCamera::reportSilhouette(const SilhouetteResult& silhouette) {
  has_been_ready_ = true;
  const auto changed = uint64_t(std::lround(100 * silhouette.changed_fraction));
  const auto light = uint64_t(std::lround(100 * silhouette.light_gain));
  const auto unknown = uint64_t(std::ceil(100 * silhouette.unknown_fraction));
  status_.set("unknown pixels, per cent", unknown);
  status_.set("changed pixels, per cent", changed);
  status_.set("light, per cent of the background's", light);
  has_seen_somebody_ = has_seen_somebody_ || silhouette.changed_fraction > kSomebody;
  if (silhouette.uncovered_fraction > 0)
    status_.remark("somebody or something stood still in view of " + camera_ +
                   " while its background was learned, and has moved away; what is behind it is "
                   "background from now on");
  if (silhouette.state == SilhouetteState::kStale)
    status_.waiting("the background is stale: " + std::to_string(changed) +
                    " % of the image differ from it, the light is " + std::to_string(light) +
                    " % of what it was; masks are published, call learn_background");
  else if (unknown > 0)
    status_.ok("ready, masks are published; the background of " + std::to_string(unknown) +
               " % of the image has not been seen yet, as somebody stood there");
  else if (!has_seen_somebody_)
    status_.ok(
        "ready, masks are published; nothing has moved in view since the background was learned, "
        "and whoever keeps still there unrecognised is taken for background until they move");
  else
    status_.ok("ready, masks are published");
}

void SilhouetteCamera::learnBackground() {
  checkInput();
  const std::lock_guard<std::mutex> lock(mutex_);
  background_.relearn();
}

void SilhouetteCamera::saveBackground() {
  checkInput();
  const std::lock_guard<std::mutex> lock(mutex_);
  background_.save();
}

void SilhouetteCamera::checkInput() const {
  if (node_options_.input != "image")
    throw std::invalid_argument("the input consists of masks, which have no background");
}

}  // namespace markerless_mocap
