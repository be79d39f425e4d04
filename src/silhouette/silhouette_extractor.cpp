#include "markerless_mocap/silhouette/silhouette_extractor.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <optional>
#include <stdexcept>
#include <utility>

#include "markerless_mocap/products/silhouette_mask.h"
#include "options/settings.h"
#include "silhouette/background/light_gain.h"
#include "silhouette/background/subtractor.h"
#include "silhouette/boundary/image_reduction.h"
#include "silhouette/recording/left_place.h"
#include "silhouette/recording/live_learner.h"

namespace markerless_mocap {
namespace {

std::string described(const cv::Size& size, int type) {
  const char* kind = type == CV_8UC1 ? " grey" : type == CV_8UC3 ? " BGR" : " of another type";
  return std::to_string(size.width) + " x " + std::to_string(size.height) + kind;
}

cv::Mat maskOf(const Extraction& found) {
  cv::Mat mask = found.mask.toMat();
  if (found.unknown.rows() > 0) mask.setTo(kUnknownPixel, found.unknown.toMat());
  return mask;
}

}  // namespace

class SilhouetteExtractor::Impl {
 public:
  explicit Impl(const SilhouetteOptions& options) : options_(options) {
    options_.validate();
    if (!learns()) subtractor_ = makeSubtractor(options_, {});  // a fault of the file is told now
  }

  int reduction(const cv::Size& whole) const { return reductionOf(whole, options_.max_megapixels); }

  SilhouetteResult update(const cv::Mat& given, const cv::Size& whole) {
    const cv::Mat image = given.size() == whole ? reducedImage(given, reduction(whole)) : given;
    checkImage(image);
    if (type_ < 0 || (!subtractor_ && frames_learned_ == 0)) begin(image);
    if (learns() && frames_learned_ < options_.background_frames && loaded_.empty()) {
      learn(image);
      return {};
    }
    if (live_) addLive(image);
    if (first_background_.valid()) takeFirstBackground();
    if (!subtractor_) return {};
    const Extraction found = subtractor_->extract(image);
    if (live_ && !live_->isLearning() && !left_place_.isHidden() && left_place_.isLeft(found))
      learnAnew();
    cv::Mat mask = maskOf(found);
    size_t unknown = found.unknown.count();
    if (left_place_.isHidden()) {
      left_place_.removeGhost(mask);
      unknown = size_t(std::count(mask.begin<uint8_t>(), mask.end<uint8_t>(), kUnknownPixel));
    }
    const double pixels = double(image.total());
    return {stateAfter(found),        enlargedMask(mask, reduction(whole), whole),
            double(unknown) / pixels, found.changed_fraction,
            found.light_gain,         double(found.uncovered) / pixels,
            left_place_.isHidden()};
  }

  void change(const SilhouetteOptions& changed) {
    const SilhouetteOptions options = withFixed(changed, options_, SilhouetteOptions::fixedKeys());
    options.validate();
    options_ = options;
    if (subtractor_) subtractor_->change(options_);
    if (live_) live_->change(options_);
  }

  void reset() {
    if (learns()) subtractor_.reset();
    first_background_ = {};
    live_.reset();
    left_place_.forget();
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
    const Background* background = current();
    if (!background)
      throw std::invalid_argument("silhouette: the background is not learned yet, " +
                                  std::to_string(frames_learned_) + " of " +
                                  std::to_string(options_.background_frames) + " images came");
    background->save(path);
  }

  SharedBackground background() const {
    const Background* background = current();
    return background ? std::make_shared<const Background>(*background) : nullptr;
  }

  void load(const std::string& path) {
    Background background = Background::load(path);
    if (background.modes() != modesOf(options_))
      throw std::invalid_argument("the background file " + path + " is not of the model " +
                                  options_.model);
    loaded_ = std::move(background);
    reset();
  }

  void use(const SharedBackground& background) {
    if (background && background->modes() != modesOf(options_))
      throw std::invalid_argument("silhouette: the given background is not of the model " +
                                  options_.model);
    loaded_ = background ? *background : Background();
    reset();
  }

  int framesLearned() const { return frames_learned_; }

  void learnBeside() { beside_ = true; }

 private:
  void checkImage(const cv::Mat& image) const;
  SilhouetteState stateAfter(const Extraction& found);

  /// Whether the model has a background.
  bool learns() const { return options_.model != "network"; }

  /// nullptr while learning, or if the model has none that can be saved.
  const Background* current() const {
    const Background* used = subtractor_ ? subtractor_->background() : nullptr;
    if (used && !used->empty()) return used;
    return loaded_.empty() ? nullptr : &loaded_;
  }

  void begin(const cv::Mat& image) {
    size_ = image.size();
    type_ = image.type();
    if (learns()) subtractor_ = makeSubtractor(options_, loaded_);
    if (loaded_.empty() && canLearnFromRecording(options_)) live_.emplace(options_);
  }

  void learn(const cv::Mat& image) {
    subtractor_->learn(image);
    if (live_) live_->add(image);
    if (++frames_learned_ < options_.background_frames) return;
    if (beside_)
      learnFirstBeside();
    else
      learnFirst();
  }

  void learnFirst() {
    if (live_ && !live_->isOccupied()) live_.reset();
    if (live_)
      subtractor_ = makeSubtractor(options_, live_->learn());
    else
      subtractor_->finishLearning();
  }

  /// There is no subtractor until this has ended.
  void learnFirstBeside() {
    const auto nobody = [] { return false; };
    first_background_ =
        std::async(std::launch::async, [is_occupied = live_ ? live_->occupancy() : nobody,
                                        learning = std::move(subtractor_)]() mutable {
          if (is_occupied()) return std::unique_ptr<Subtractor>();
          learning->finishLearning();
          return std::move(learning);
        });
  }

  void takeFirstBackground() {
    if (first_background_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    subtractor_ = first_background_.get();
    if (!subtractor_) return live_->learnBeside(true);
    live_.reset();
    subtractor_->change(options_);  // they may have changed
  }

  /// From the images that follow. The background so far is used until then: masks go on.
  void learnAnew() {
    live_.emplace(options_);
    left_place_.hide(subtractor_->background()->person());
  }

  void addLive(const cv::Mat& image) {
    live_->add(image);
    if (first_background_.valid()) return;
    if (live_->isDue() && beside_)
      live_->learnBeside(!subtractor_);
    else if (live_->isDue())
      replaceBackground(live_->learn());
    if (const std::optional<Background> better = live_->learned()) replaceBackground(*better);
    if (live_->isDone()) live_.reset();
  }

  void replaceBackground(const Background& background) {
    subtractor_ = makeSubtractor(options_, background);
    left_place_.forget();
  }

  SilhouetteOptions options_;
  std::optional<LiveLearner> live_;         ///< as long as the background gets better
  bool beside_ = false;                     ///< it is learned again beside the images
  LeftPlace left_place_;                    ///< hidden while the background is learned anew
  std::unique_ptr<Subtractor> subtractor_;  ///< none before the first image and while it is learned
  /// Beside the images; nullptr where somebody is in them.
  std::future<std::unique_ptr<Subtractor>> first_background_;
  Background loaded_;  ///< background from a file or given; else empty
  int frames_learned_ = 0;
  int stale_run_ = 0;  ///< number of images in a row that differ too much from the background
  cv::Size size_;
  int type_ = -1;  ///< of the images; -1 before the first
};

void SilhouetteExtractor::Impl::checkImage(const cv::Mat& image) const {
  if (image.empty()) throw std::invalid_argument("silhouette: the image is empty");
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3)
    throw std::invalid_argument(
        "silhouette: the image has pixels of " + std::to_string(image.channels()) + " x " +
        std::to_string(8 * image.elemSize1()) + " bits, allowed is 8 bit grey or BGR");
  if (type_ >= 0 && (image.size() != size_ || image.type() != type_))
    throw std::invalid_argument(
        "silhouette: the image is " + described(image.size(), image.type()) + ", allowed is " +
        described(size_, type_) +
        (learns() ? ", as its background is, or to learn that anew" : ", as the first one was"));
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
  return impl_->update(image, image.size());
}

int SilhouetteExtractor::reductionFor(const cv::Size& image) const {
  return impl_->reduction(image);
}

SilhouetteResult SilhouetteExtractor::update(const cv::Mat& image, const cv::Size& whole) {
  return impl_->update(image, whole);
}

void SilhouetteExtractor::change(const SilhouetteOptions& options) {
  impl_->change(options);
}

void SilhouetteExtractor::reset() {
  impl_->reset();
}

void SilhouetteExtractor::relearn() {
  impl_->relearn();
}

void SilhouetteExtractor::learnBeside() {
  impl_->learnBeside();
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

SharedBackground SilhouetteExtractor::background() const {
  return impl_->background();
}

void SilhouetteExtractor::useBackground(const SharedBackground& background) {
  impl_->use(background);
}

}  // namespace markerless_mocap
