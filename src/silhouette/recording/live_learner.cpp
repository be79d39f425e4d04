#include "silhouette/recording/live_learner.h"

#include "silhouette/recording/first_images.h"
#include "silhouette/recording/recording_background.h"

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

bool LiveLearner::isOccupied() const {
  return options_.background == "recording" || showMotion(sampler_.motion());
}

Background LiveLearner::learn() {
  next_ *= 2;
  Background background = learnFromRecording(sampler_.samples(options_.compensate_flicker));
  if (!background.hasUnknown()) next_ = last_ + 1;
  return background;
}

}  // namespace markerless_mocap
