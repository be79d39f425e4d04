#include "markerless_mocap/silhouette/silhouette_extractor.h"

#include <stdexcept>

#include "silhouette/background/light_gain.h"
#include "silhouette/background/subtractor.h"

namespace markerless_mocap {
namespace {

std::string described(const cv::Size& size, int type) {
  const char* kind = type == CV_8UC1 ? " grey" : type == CV_8UC3 ? " BGR" : " of another type";
  return std::to_string(size.width) + " x " + std::to_string(size.height) + kind;
}

}  // namespace

class SilhouetteExtractor::Impl {
 public:
  explicit Impl(const SilhouetteOptions& options) : options_(options) { options_.validate(); }

  SilhouetteResult update(const cv::Mat& image) {
    checkImage(image);
    if (!subtractor_) begin(image);
    if (frames_learned_ < options_.background_frames && loaded_.empty()) {
      subtractor_->learn(image);
      if (++frames_learned_ == options_.background_frames) subtractor_->finishLearning();
      return {};
    }
    const Extraction found = subtractor_->extract(image);
    return {stateAfter(found), found.mask.toMat(), found.changed_fraction, found.light_gain};
  }

  void reset() {
    subtractor_.reset();
    frames_learned_ = stale_run_ = 0;
    size_ = loaded_.size();
    type_ = loaded_.empty() ? -1 : loaded_.type();
  }

  void relearn() {
    loaded_ = Background();
    reset();
  }

  void save(const std::string& path) const {
    if (modesOf(options_) == 0)
      throw std::invalid_argument("silhouette: the background of the model " + options_.model +
                                  " cannot be saved, allowed are gaussian and mean_shift");
    const bool is_learned = subtractor_ && !subtractor_->background()->empty();
    if (!is_learned && loaded_.empty())
      throw std::invalid_argument("silhouette: the background is not learned yet, " +
                                  std::to_string(frames_learned_) + " of " +
                                  std::to_string(options_.background_frames) + " images came");
    (is_learned ? *subtractor_->background() : loaded_).save(path);
  }

  void load(const std::string& path) {
    Background background = Background::load(path);
    if (background.modes() != modesOf(options_))
      throw std::invalid_argument("the background file " + path + " is not of the model " +
                                  options_.model);
    loaded_ = std::move(background);
    reset();
  }

  int framesLearned() const { return frames_learned_; }

 private:
  void checkImage(const cv::Mat& image) const;
  SilhouetteState stateAfter(const Extraction& found);

  void begin(const cv::Mat& image) {
    size_ = image.size();
    type_ = image.type();
    subtractor_ = makeSubtractor(options_, loaded_);
  }

  SilhouetteOptions options_;
  std::unique_ptr<Subtractor> subtractor_;  ///< created at the first image
  Background loaded_;                       ///< background from a file, as loaded; else empty
  int frames_learned_ = 0;
  int stale_run_ = 0;  ///< number of images in a row that differ too much from the background
  cv::Size size_;
  int type_ = -1;  ///< of the images; -1 before the first
};

void SilhouetteExtractor::Impl::checkImage(const cv::Mat& image) const {
  if (image.empty()) throw std::invalid_argument("silhouette: the image is empty");
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3)
    throw std::invalid_argument("silhouette: the image must be 8 bit grey or BGR");
  if (type_ >= 0 && (image.size() != size_ || image.type() != type_))
    throw std::invalid_argument("silhouette: the image is " +
                                described(image.size(), image.type()) + ", the background is " +
                                described(size_, type_));
}

SilhouetteState SilhouetteExtractor::Impl::stateAfter(const Extraction& found) {
  const bool at_limit = found.light_gain <= kDarkestGain || found.light_gain >= kBrightestGain;
  stale_run_ = found.changed_fraction > options_.stale_fraction || at_limit ? stale_run_ + 1 : 0;
  return stale_run_ >= options_.stale_frames ? SilhouetteState::kStale : SilhouetteState::kReady;
}

SilhouetteExtractor::SilhouetteExtractor(const SilhouetteOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}
SilhouetteExtractor::~SilhouetteExtractor() = default;
SilhouetteExtractor::SilhouetteExtractor(SilhouetteExtractor&&) noexcept = default;
SilhouetteExtractor& SilhouetteExtractor::operator=(SilhouetteExtractor&&) noexcept = default;

SilhouetteResult SilhouetteExtractor::update(const cv::Mat& image) {
  return impl_->update(image);
}

void SilhouetteExtractor::reset() {
  impl_->reset();
}

void SilhouetteExtractor::relearn() {
  impl_->relearn();
}

int SilhouetteExtractor::framesLearned() const {
  return impl_->framesLearned();
}

void SilhouetteExtractor::saveBackground(const std::string& path) const {
  impl_->save(path);
}

void SilhouetteExtractor::loadBackground(const std::string& path) {
  impl_->load(path);
}

}  // namespace markerless_mocap
