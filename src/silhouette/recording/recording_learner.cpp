#include "markerless_mocap/silhouette/recording_learner.h"

#include <algorithm>
#include <opencv2/core/utility.hpp>
#include <optional>
#include <stdexcept>

#include "silhouette/boundary/image_reduction.h"
#include "silhouette/recording/first_images.h"
#include "silhouette/recording/recording_background.h"
#include "silhouette/recording/still_person.h"

namespace markerless_mocap {
namespace {

constexpr int kSamples = 48;  ///< of a recording
/// Of the samples, one in so many is compared with the first images.
constexpr int kLaterStride = 3;

}  // namespace

bool canLearnFromRecording(const SilhouetteOptions& options) {
  return options.model == "gaussian" && options.background != "first_images";
}

double unknownFraction(const Background& background) {
  return double(background.unknown().count()) / background.size().area();
}

class RecordingLearner::Impl {
 public:
  Impl(const SilhouetteOptions& options, int expected_images)
      : options_(options), stride_(std::max(1, expected_images / kSamples)), sampler_(stride_) {
    options_.validate();
    if (!canLearnFromRecording(options_))
      throw std::invalid_argument(
          "silhouette: model " + options_.model + " with background " + options_.background +
          " does not learn from a recording, allowed is gaussian with auto or recording");
  }

  bool wantsNext() const {
    if (seen_ < options_.background_frames && first_.wantsNext()) return true;
    return is_quiet_ ? isLaterNext() : sampler_.wantsNext();
  }

  void add(const cv::Mat& full) {
    check(full);
    const cv::Mat image =
        full.empty() ? full : reducedImage(full, reductionOf(full.size(), options_.max_megapixels));
    if (seen_ < options_.background_frames) first_.add(first_.wantsNext() ? image : cv::Mat());
    if (is_quiet_ && isLaterNext() && !image.empty()) later_.push_back(smallCopy(image));
    sampler_.add(sampler_.wantsNext() ? image : cv::Mat());
    if (++seen_ == options_.background_frames) closeFirst();
  }

  bool isOccupiedAtFirst() const {
    if (options_.background == "recording") return true;
    if (seen_ < options_.background_frames)
      return !first_.empty() && (showMotion(first_.motion()) || showsPerson(first_.last()));
    if (!is_quiet_) return true;
    return first_samples_ &&
           (showsPerson(last_of_first_) || showWhatLeftLater(*first_samples_, later_));
  }

  SharedBackground learn() const {
    return std::make_shared<Background>(
        learnFromRecording(sampler_.samples(options_.compensate_flicker), startsStill()));
  }

 private:
  void check(const cv::Mat& image) {
    if (image.empty()) return;
    if (image.type() != CV_8UC1 && image.type() != CV_8UC3)
      throw std::invalid_argument("silhouette: the image must be 8 bit grey or BGR");
    if (type_ >= 0 && (image.type() != type_ || image.size() != size_))
      throw std::invalid_argument("silhouette: the images of a recording differ in size or type");
    type_ = image.type();
    size_ = image.size();
  }

  bool isLaterNext() const { return seen_ % (kLaterStride * stride_) == 0; }

  bool startsStill() const {
    return first_samples_ ? !showMotion(first_samples_->moving) : !showMotion(first_.motion());
  }

  /// The first images are complete.
  void closeFirst() {
    if (type_ < 0) return;
    first_samples_ = first_.samples(options_.compensate_flicker);
    last_of_first_ = first_.last();
    is_quiet_ = options_.background != "recording" && startsStill();
    first_ = SceneSampler();
  }

  SilhouetteOptions options_;
  int stride_, seen_ = 0, type_ = -1;
  cv::Size size_;
  bool is_quiet_ = false;  ///< nothing moves in the first images
  SceneSampler first_, sampler_;
  std::optional<SceneSamples> first_samples_;
  cv::Mat last_of_first_;  ///< whole; samples may lack their whole images
  std::vector<cv::Mat> later_;
};

RecordingLearner::RecordingLearner(const SilhouetteOptions& options, int expected_images)
    : impl_(std::make_unique<Impl>(options, expected_images)) {}
RecordingLearner::~RecordingLearner() = default;
RecordingLearner::RecordingLearner(RecordingLearner&&) noexcept = default;
RecordingLearner& RecordingLearner::operator=(RecordingLearner&&) noexcept = default;

bool RecordingLearner::wantsNext() const {
  return impl_->wantsNext();
}

void RecordingLearner::add(const cv::Mat& image) {
  impl_->add(image);
}

bool RecordingLearner::isOccupiedAtFirst() const {
  return impl_->isOccupiedAtFirst();
}

SharedBackground RecordingLearner::learn() const {
  return impl_->learn();
}

std::vector<SharedBackground> learnBackgrounds(const std::vector<RecordingLearner>& learners) {
  const size_t n = learners.size();
  std::vector<SharedBackground> backgrounds(n);
  std::vector<char> occupied(n);
  const cv::Range all(0, int(n));
  cv::parallel_for_(all, [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i) occupied[i] = learners[i].isOccupiedAtFirst();
  });
  if (2 * size_t(std::count(occupied.begin(), occupied.end(), true)) < n) return backgrounds;
  cv::parallel_for_(all, [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i)
      if (occupied[i]) backgrounds[i] = learners[i].learn();
  });
  return backgrounds;
}

}  // namespace markerless_mocap
