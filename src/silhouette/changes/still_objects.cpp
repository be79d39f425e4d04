#include "silhouette/changes/still_objects.h"

#include <algorithm>
#include <limits>

#include "silhouette/bits/bit_morphology.h"
#include "silhouette/changes/image_change.h"
#include "silhouette/image_cycle.h"

namespace markerless_mocap {
namespace {

/// One image in this many is looked at; a component is an object after kChecks of them.
constexpr int kStep = 10;
static_assert(kImageCycle % kStep == 0);
constexpr size_t kChecks = 2;
/// A component is still if fewer of its pixels have changed, and moves if more have.
constexpr double kStillFraction = 0.01, kMovingFraction = 0.05;
constexpr int kStillPixels = 3;
/// Minimum area of a component that counts as moving, px.
constexpr int kMinMoving = 400;
/// A still component this near a moving one belongs to it, px.
constexpr int kNear = 8;
/// Blur spreads an object over this many pixels around its part of the mask.
constexpr int kBlur = 3;
/// Fraction of an object's pixels that must show what was behind it before it is gone.
constexpr double kUncovered = 0.15;
/// Fraction of a component that must have been still before.
constexpr double kSamePlace = 0.9;

/// Copies the rows of the components, and those that blur reaches.
void copyRows(const std::vector<std::vector<MaskRun>>& components, const cv::Mat& image,
              cv::Mat* copy) {
  int first = image.rows, last = 0;
  for (const std::vector<MaskRun>& component : components) {
    first = std::min(first, component.front().y);
    last = std::max(last, component.back().y);
  }
  const cv::Range rows(std::max(0, first - kBlur), std::min(image.rows, last + kBlur + 1));
  image.rowRange(rows).copyTo(copy->rowRange(rows));
}

bool touches(const std::vector<MaskRun>& component, const BitMask& mask) {
  for (const MaskRun& run : component)
    for (int x = run.first; x <= run.last; ++x)
      if (mask.at(x, run.y)) return true;
  return false;
}

BitMask pixelsOf(const std::vector<MaskRun>& component, const cv::Size& size) {
  BitMask pixels(size);
  fillRuns(component, &pixels);
  return pixels;
}

}  // namespace

void StillObjects::clear() {
  objects_.clear();
  still_.clear();
  previous_.release();
}

bool StillObjects::update(const cv::Mat& image, double gain, Background* background,
                          BitMask* mask) {
  if (images_++ % kStep != 0) return false;
  unknown_changed_ = false;
  noise_ = background->noise();
  if (!objects_.empty()) restoreUncovered(image, gain, background);
  const std::vector<Component> components = findBlobs(std::numeric_limits<int>::max(), *mask);
  if (components.size() < 2) {
    previous_.release();
    still_.clear();
    return unknown_changed_;
  }
  if (previous_.empty())
    previous_ = cv::Mat::zeros(image.size(), image.type());
  else
    compare(components, image, gain, background, mask);
  copyRows(components, image, &previous_);
  previous_gain_ = gain;
  return unknown_changed_;
}

void StillObjects::compare(const std::vector<Component>& components, const cv::Mat& image,
                           double gain, Background* background, BitMask* mask) {
  BitMask still(background->size()), moving(background->size());
  std::vector<const Component*> candidates;
  for (const Component& component : components) {
    const Motion motion = motionOf(component, image, gain);
    if (motion.changed <= kStillPixels + kStillFraction * motion.area) {
      fillRuns(component, &still);
      if (wasStill(component)) candidates.push_back(&component);
    } else if (motion.area >= kMinMoving && motion.changed >= kMovingFraction * motion.area) {
      fillRuns(component, &moving);
    }
  }
  if (!candidates.empty() && moving.count() > 0) {
    const BitMask near = dilated(moving, kNear);
    for (const Component* component : candidates)
      if (!touches(*component, near))
        absorb(takeOut(pixelsOf(*component, background->size()), kBlur, mask), image, gain,
               background);
  }
  still_.push_back(std::move(still));
  if (still_.size() >= kChecks) still_.pop_front();
}

StillObjects::Motion StillObjects::motionOf(const Component& component, const cv::Mat& image,
                                            double gain) const {
  const int channels = image.channels();
  const float limit = float(kNoiseVariances * noise_ * noise_);
  const float per_gain = float(1 / gain), per_gain_then = float(1 / previous_gain_);
  Motion motion;
  for (const MaskRun& run : component) {
    motion.area += run.last - run.first + 1;
    const int first = std::max(0, run.first - 1), last = std::min(image.cols - 1, run.last + 1);
    const uint8_t* now = image.ptr(run.y);
    const uint8_t* then = previous_.ptr(run.y);
    for (int x = first; x <= last; ++x) {
      const ptrdiff_t at = ptrdiff_t(x) * channels;
      motion.changed +=
          squaredDistance(now + at, per_gain, then + at, per_gain_then, channels) > limit;
    }
  }
  return motion;
}

bool StillObjects::wasStill(const Component& component) const {
  if (still_.size() + 1 < kChecks) return false;
  for (const BitMask& still : still_) {
    int area = 0, same = 0;
    for (const MaskRun& run : component)
      for (int x = run.first; x <= run.last; ++x, ++area) same += still.at(x, run.y);
    if (same < kSamePlace * area) return false;
  }
  return true;
}

void StillObjects::absorb(const BitMask& place, const cv::Mat& image, double gain,
                          Background* background) {
  const int channels = image.channels();
  const StillImages images{image, gain, previous_, previous_gain_};
  Object object;
  for (int y = 0; y < image.rows; ++y) {
    const size_t before = object.size();
    for (int i = 0; i < place.rowWords(); ++i)
      forEachBit(place.row(y)[i], 64 * i, [&](int x) {
        Pixel pixel{x, y, {}, background->isUnknown(x, y)};
        if (pixel.was_unknown) {
          background->setUnknown(x, y, false);
          background->sigma(0, y)[x] = uint16_t(noise_ * Background::kMeanScale);
          unknown_changed_ = true;
        }
        for (int c = 0; c < channels; ++c) {
          uint16_t& mean = background->mean(0, y, c)[x];
          pixel.before[c] = mean;
          mean = images.mean(x, y, c);
        }
        object.push_back(pixel);
      });
    if (object.size() > before) background->updateQuantised(0, y);
  }
  objects_.push_back(std::move(object));
}

bool StillObjects::isGone(const Object& object, const cv::Mat& image, double gain,
                          const Background& background) const {
  const int channels = image.channels();
  const double limit = kNoiseVariances / 2 * noise_ * noise_;
  size_t clear = 0, uncovered = 0;
  for (const Pixel& pixel : object) {
    if (pixel.was_unknown) continue;
    double to_before = 0, apart = 0;
    for (int c = 0; c < channels; ++c) {
      const double now = image.ptr(pixel.y)[pixel.x * channels + c] / gain;
      const double before = pixel.before[c] / double(Background::kMeanScale);
      const double covered =
          background.mean(0, pixel.y, c)[pixel.x] / double(Background::kMeanScale);
      to_before += (now - before) * (now - before);
      apart += (covered - before) * (covered - before);
    }
    if (apart < 4 * limit) continue;  // the object looks like what is behind it
    ++clear;
    uncovered += to_before < limit;
  }
  return clear > 0 && uncovered > kUncovered * clear;
}

void StillObjects::restore(const Object& object, Background* background) {
  for (const Pixel& pixel : object) {
    for (int c = 0; c < background->channels(); ++c)
      background->mean(0, pixel.y, c)[pixel.x] = pixel.before[c];
    if (!pixel.was_unknown) continue;
    background->setUnknown(pixel.x, pixel.y, true);
    unknown_changed_ = true;
  }
  for (size_t i = 0; i < object.size(); ++i)
    if (i == 0 || object[i].y != object[i - 1].y) background->updateQuantised(0, object[i].y);
}

void StillObjects::restoreUncovered(const cv::Mat& image, double gain, Background* background) {
  const auto gone = std::stable_partition(
      objects_.begin(), objects_.end(),
      [&](const Object& object) { return !isGone(object, image, gain, *background); });
  // The last comes first, as an object may lie on one that was there before.
  for (auto object = objects_.end(); object != gone;) restore(*--object, background);
  objects_.erase(gone, objects_.end());
}

}  // namespace markerless_mocap
