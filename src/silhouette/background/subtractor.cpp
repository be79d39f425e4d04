#include "silhouette/background/subtractor.h"

#include <algorithm>
#include <cmath>

#include "silhouette/background/background_learner.h"
#include "silhouette/background/light_gain.h"
#include "silhouette/background/pixel_test.h"
#include "silhouette/background/row_kernels.h"
#include "silhouette/bits/bit_morphology.h"
#include "silhouette/bits/mask_runs.h"
#include "silhouette/bits/prefetch.h"
#include "silhouette/boundary/boundary_matting.h"
#include "silhouette/boundary/clean_mask.h"
#include "silhouette/boundary/hole_filling.h"
#include "silhouette/changes/kept_texture.h"
#include "silhouette/changes/light_switch.h"
#include "silhouette/changes/still_objects.h"
#include "silhouette/changes/uncovered_places.h"
#include "silhouette/image_cycle.h"

namespace markerless_mocap {
namespace {

/// Each image updates one row in this many, with this many times the rate.
constexpr int kUpdateStride = 16;
static_assert(kImageCycle % kUpdateStride == 0);
/// The background is not updated this near the person, px, so that parts missing in the mask are
/// not learned as background.
constexpr int kGuardX = 16, kGuardY = 8;
/// A light, or a scene, that is quite another is only learned from after so many images.
constexpr int kOddImages = kImageCycle;
/// The boundary of the person is not refined this near unknown pixels, px.
constexpr int kUnrefinedReach = 3;
/// Of the outline of somebody who keeps still, the image shows so much of them until they go.
constexpr double kStaying = 0.7;

class ModelSubtractor : public Subtractor {
 public:
  ModelSubtractor(const SilhouetteOptions& options, Background background)
      : options_(options),
        learner_(options.background_frames, options.compensate_flicker),
        background_(std::move(background)) {
    if (!background_.empty()) setThreshold();
  }

  void learn(const cv::Mat& image) override { learner_.add(image); }

  void finishLearning() override {
    background_ = learner_.learn(modesOf(options_), options_.min_sigma);
    setThreshold();
    learner_ = BackgroundLearner(options_.background_frames, options_.compensate_flicker);
  }

  Extraction extract(const cv::Mat& image) override {
    // The buffers are shared by all cameras of a thread, so that they stay in the cache.
    static thread_local PixelTest test;
    static thread_local BoundaryMatting matting;
    Extraction found;
    if (options_.compensate_flicker) found.light_gain = followLight(image);
    PixelClasses& classes = test.classify(options_, image, background_, found.light_gain);
    found.changed_fraction = double(classes.changed) / double(image.total());
    if (options_.follow_changes && options_.remove_shadows)
      kept_texture_.findLit(image, background_, found.light_gain, &classes);
    found.mask = cleaned(classes.foreground);
    const BitMask unrefined = nearUnknown(found.mask);
    matting.refine(image, background_, found.light_gain, classes, &found.mask);
    // This comes last, as the new boundary has pinholes and specks.
    fillFalseHoles(image, background_, found.light_gain, options_.max_hole_px, &found.mask);
    if (background_.hasUnknown()) restoreUnknown(unrefined, classes, &found);
    removeBlobs(options_.min_blob_px, &found.mask);
    follow(image, classes.shadow, &found);
    return found;
  }

  void change(const SilhouetteOptions& options) override {
    options_ = options;
    if (!background_.empty()) setThreshold();
  }

  const Background* background() const override { return &background_; }

 private:
  void setThreshold();
  double followLight(const cv::Mat& image);
  bool isOdd(const Extraction& found) const {
    return found.light_gain <= kDarkestGain || found.light_gain >= kBrightestGain ||
           found.changed_fraction > options_.stale_fraction;
  }
  bool followsLamps() const { return options_.follow_changes && !background_.hasUnknown(); }
  void follow(const cv::Mat& image, const BitMask& shadow, Extraction* found);
  void absorbObjects(const cv::Mat& image, Extraction* found);
  BitMask cleaned(const BitMask& foreground) const;
  BitMask nearUnknown(const BitMask& mask) const;
  BitMask stayingPerson(const PixelClasses& classes) const;
  void restoreUnknown(const BitMask& unrefined, const PixelClasses& classes,
                      Extraction* found) const;
  void updateBackground(const cv::Mat& image, double gain, const BitMask& mask,
                        const BitMask& shadow);

  SilhouetteOptions options_;
  BackgroundLearner learner_;
  Background background_;
  BitMask near_unknown_;  ///< where the boundary is not refined; only if something is unknown
  BitMask last_mask_;
  LightSwitch light_switch_;
  KeptTexture kept_texture_;
  StillObjects still_objects_;
  UncoveredPlaces uncovered_;
  int odd_run_ = 0;   ///< images in a row that are unlike the background
  int next_row_ = 0;  ///< first row that the next image updates
  std::vector<uint8_t> now_, held_;
  std::vector<uint64_t> guarded_;
};

void ModelSubtractor::setThreshold() {
  background_.setThreshold(options_.threshold_sigmas, options_.min_sigma);
  if (background_.hasUnknown()) near_unknown_ = dilated(background_.unknown(), kUnrefinedReach);
}

/// The gain of the image, after the background has followed a switch of the light.
double ModelSubtractor::followLight(const cv::Mat& image) {
  const LightGain light = estimateLightGain(image, background_);
  if (!followsLamps() || isClipped(image, light.gain) ||
      !light_switch_.update(image, light, last_mask_, &background_))
    return light.gain;
  still_objects_.clear();
  uncovered_.clear();
  return estimateLightGain(image, background_).gain;
}

/// Unknown pixels count as foreground in the morphology, so that the person is not eroded there,
/// and are removed afterwards.
BitMask ModelSubtractor::cleaned(const BitMask& foreground) const {
  if (!background_.hasUnknown()) return openedAndClosed(foreground, options_);
  BitMask all = foreground;
  all |= background_.unknown();
  all = openedAndClosed(all, options_);
  all.remove(background_.unknown());
  return all;
}

/// The mask where refining needs colours that are unknown.
BitMask ModelSubtractor::nearUnknown(const BitMask& mask) const {
  if (!background_.hasUnknown()) return {};
  BitMask near = mask;
  near &= near_unknown_;
  return near;
}

void ModelSubtractor::restoreUnknown(const BitMask& unrefined, const PixelClasses& classes,
                                     Extraction* found) const {
  found->mask.remove(near_unknown_);
  found->mask |= unrefined;
  found->mask |= background_.unknown();
  found->unknown = background_.unknown();
  const BitMask person = stayingPerson(classes);
  found->has_left_place = background_.person().count() > 0 && person.count() == 0;
  found->unknown.remove(person);
}

/// Where the image still shows somebody who has kept still. Of one who has gone, what is left are
/// things of their colours beside them: empty.
BitMask ModelSubtractor::stayingPerson(const PixelClasses& classes) const {
  BitMask person = background_.person();
  person.remove(classes.foreground);
  person.remove(classes.shadow);
  const bool has_gone = double(person.count()) < kStaying * double(background_.person().count());
  return has_gone ? BitMask() : person;
}

/// Takes over what has changed in the scene. Light that blinds the camera teaches nothing.
void ModelSubtractor::follow(const cv::Mat& image, const BitMask& shadow, Extraction* found) {
  const bool is_odd = isOdd(*found);
  odd_run_ = is_odd ? odd_run_ + 1 : 0;
  if (!is_odd || (odd_run_ > kOddImages && !isClipped(image, found->light_gain)))
    updateBackground(image, found->light_gain, found->mask, shadow);
  if (is_odd) return;
  if (options_.follow_changes) {
    found->uncovered = uncovered_.update(image, found->light_gain, &background_, &found->mask);
    absorbObjects(image, found);
  }
  last_mask_ = found->mask;
}

void ModelSubtractor::absorbObjects(const cv::Mat& image, Extraction* found) {
  if (!still_objects_.update(image, found->light_gain, &background_, &found->mask)) return;
  setThreshold();
  found->unknown = background_.unknown();
}

/// Moves the means towards the image, so that a slow change of the light is learned. Behind the
/// person and in shadows they follow the light of the whole scene instead.
void ModelSubtractor::updateBackground(const cv::Mat& image, double gain, const BitMask& mask,
                                       const BitMask& shadow) {
  if (options_.update_rate == 0) return;
  const int n = background_.stride(), channels = background_.channels();
  const auto rate =
      int16_t(std::lround(std::min(1.0, options_.update_rate * kUpdateStride) * 32767));
  const auto fixed_gain = int16_t(std::lround(gain * kGainOne));
  now_.resize(size_t(3) * n);
  held_.resize(n);
  for (int y = next_row_; y < image.rows; y += kUpdateStride) {
    if (const int next = y + kUpdateStride; next < image.rows) {
      prefetch(background_.mean(0, next, 0), sizeof(uint16_t) * channels * n);
      prefetch(image.ptr(next), size_t(channels) * image.cols);
    }
    splitRow(image, y, 0, image.cols, n, now_.data());
    nearRow(mask, y, kGuardX, kGuardY, &guarded_);
    for (int i = 0; i < mask.rowWords(); ++i) guarded_[i + 1] |= shadow.row(y)[i];
    unpackBits(&guarded_[1], image.cols, held_.data());
    for (int c = 0; c < channels; ++c)
      moveMeans(&now_[size_t(c) * n], held_.data(), fixed_gain, rate, image.cols,
                background_.mean(0, y, c));
    background_.updateQuantised(0, y);
  }
  next_row_ = (next_row_ + 1) % kUpdateStride;
}

}  // namespace

int modesOf(const SilhouetteOptions& options) {
  if (options.model == "gaussian") return 1;
  return options.model == "mean_shift" ? Background::kMaxModes : 0;
}

std::unique_ptr<Subtractor> makeSubtractor(const SilhouetteOptions& options,
                                           const Background& background) {
  if (options.model == "network") return makeNetworkSubtractor(options);
  if (modesOf(options) == 0) return makeOpenCvSubtractor(options);
  return std::make_unique<ModelSubtractor>(options, background);
}

}  // namespace markerless_mocap
