#include "silhouette/recording/live_learner.h"

#include <chrono>
#include <mutex>
#include <utility>

#include "numerics/low_priority.h"
#include "silhouette/recording/first_images.h"
#include "silhouette/recording/recording_background.h"
#include "silhouette/recording/still_person.h"

namespace markerless_mocap {
namespace {

/// The background is learned for the last time after this many times `background_frames`.
constexpr int kLastFactor = 32;

}  // namespace

LiveLearner::LiveLearner(const SilhouetteOptions& options)
    : options_(options),
      next_(options.background_frames),
      last_(options.background_frames * kLastFactor) {}

void LiveLearner::add(const cv::Mat& image) {
  sampler_.add(sampler_.wantsNext() ? image : cv::Mat());
}

bool LiveLearner::startsStill() {
  if (!starts_still_) starts_still_ = !showMotion(sampler_.motion());
  return *starts_still_;
}

std::function<bool()> LiveLearner::occupancy() {
  const bool is_still = startsStill();
  if (options_.background == "recording" || !is_still) return [] { return true; };
  return [last = sampler_.last().clone()] { return showsPerson(last); };
}

void LiveLearner::schedule(const Background& background) {
  if (!background.hasUnknown()) next_ = last_ + 1;
}

Background LiveLearner::learn() {
  next_ *= 2;
  Background background =
      learnFromRecording(sampler_.samples(options_.compensate_flicker), startsStill());
  schedule(background);
  return background;
}

void LiveLearner::learnBeside(bool is_awaited) {
  next_ *= 2;
  if (learning_.valid()) return;
  learning_ = std::async(std::launch::async, [sampler = sampler_, options = options_, is_awaited,
                                              starts_still = startsStill()] {
    const auto learn = [&] {
      return learnFromRecording(sampler.samples(options.compensate_flicker), starts_still);
    };
    if (is_awaited) return learn();
    static std::mutex one_camera_after_another;
    const std::lock_guard lock(one_camera_after_another);
    return unobtrusively(learn);
  });
}

std::optional<Background> LiveLearner::learned() {
  if (!learning_.valid() ||
      learning_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  Background background = learning_.get();
  schedule(background);
  return background;
}

}  // namespace markerless_mocap
