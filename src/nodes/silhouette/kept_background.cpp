#include "nodes/silhouette/kept_background.h"

#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "files/whole_file.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

constexpr int kCheckedImages = 3;
constexpr double kMostChanged = 0.5;     // of the image; a person covers less
constexpr double kMostGain = 1.6;        // with another exposure, colours are no longer the same
constexpr double kSaveInterval = 600.0;  // s; the background follows the light of the day
constexpr double kSettled = 5.0;         // s without a new piece of background before it is saved

/// Whether the image is like the background.
bool isLike(const SilhouetteResult& result) {
  const double gain = std::max(result.light_gain, 1.0 / result.light_gain);
  return result.changed_fraction <= kMostChanged && gain <= kMostGain;
}

std::string percent(double fraction) {
  return std::to_string(std::lround(100 * fraction)) + " %";
}

}  // namespace

KeptBackground::KeptBackground(const std::string& camera, const SilhouetteNodeOptions& options,
                               SilhouetteExtractor* extractor, StageStatus* status)
    : camera_(camera),
      file_(options.backgroundFile(camera)),
      keeps_(options.keep_background && !file_.empty()),
      extractor_(extractor),
      status_(status) {
  std::error_code unreadable;  // told by loading it
  if (file_.empty() || (!fs::exists(file_, unreadable) && !unreadable)) return;
  try {
    extractor_->loadBackground(file_);
    unchecked_ = kCheckedImages;
  } catch (const std::exception& error) {  // of ours, or of the file system
    status_->remark(std::string(error.what()) + "; it is learned anew");
  }
}

std::optional<SilhouetteResult> KeptBackground::update(const cv::Mat& image,
                                                       const cv::Size& whole) {
  if (unchecked_ > 0) return checked(image, whole);
  const SilhouetteResult result = extractor_->update(image, whole);
  if (keeps_) keep(result);
  return result;
}

std::optional<SilhouetteResult> KeptBackground::checked(const cv::Mat& image,
                                                        const cv::Size& whole) {
  SilhouetteResult result;
  try {
    result = extractor_->update(image, whole);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
    return std::nullopt;
  }
  if (!isLike(result)) {
    refuse(percent(result.changed_fraction) + " of the image differ from it, the light is " +
           percent(result.light_gain) + " of what it was");
    return std::nullopt;
  }
  if (--unchecked_ == 0) status_->remark("the background of " + camera_ + " is that of " + file_);
  return result;
}

void KeptBackground::refuse(const std::string& why) {
  status_->remark("the background in " + file_ + " is not that of " + camera_ + " now: " + why +
                  "; it is learned anew");
  relearn();
}

void KeptBackground::relearn() {
  unchecked_ = 0;
  saved_at_.reset();
  extractor_->relearn();
}

void KeptBackground::keep(const SilhouetteResult& result) {
  const double now = ros::SteadyTime::now().toSec();
  if (result.uncovered_fraction > 0 || result.is_learned_anew)
    saved_at_ = now - kSaveInterval + kSettled;
  const bool is_due = !saved_at_ || now - *saved_at_ > kSaveInterval;
  if (!is_due || result.state != SilhouetteState::kReady || result.unknown_fraction > 0.0 ||
      !isLike(result))
    return;
  saved_at_ = now;
  try {
    save();
  } catch (const std::exception& error) {
    status_->remark(error.what());
  }
}

void KeptBackground::save() {
  if (file_.empty())
    throw std::invalid_argument("background_folder is empty, allowed is the folder to write to");
  writeWholeFileBy(file_, [&](const std::string& draft) {
    fs::permissions(draft, fs::perms::owner_read | fs::perms::owner_write);
    extractor_->saveBackground(draft);
    return true;
  });
}

}  // namespace markerless_mocap
