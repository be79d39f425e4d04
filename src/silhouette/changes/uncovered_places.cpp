#include "silhouette/changes/uncovered_places.h"

#include <limits>
#include <utility>

#include "silhouette/bits/bit_morphology.h"
#include "silhouette/bits/mask_runs.h"
#include "silhouette/changes/image_change.h"
#include "silhouette/image_cycle.h"

namespace markerless_mocap {
namespace {

/// One image in this many is looked at.
constexpr int kStep = 5;
static_assert(kImageCycle % kStep == 0);
/// Pixels this near what moves are not still: blur.
constexpr int kBlur = 3;
/// Colours beside an outline are taken this far from it, px.
constexpr int kBeside = 3;
/// An outline is told from so many ends of runs.
constexpr int kFewestEnds = 12;
/// Mean squared difference across the outline: so many times as large in the background as in the
/// image. Before a background with a pattern of its own it is at most twice as large, as the image
/// shows that pattern beside a person, too.
constexpr double kRatio = 4;
/// Mean difference across the outline in the background, grey levels over all channels.
constexpr double kContrast = 30;

/// Squared differences of the colours inside and outside, summed over ends of runs.
struct Outline {
  int ends = 0;
  double image = 0, background = 0;

  bool isGhost() const {
    return ends >= kFewestEnds && background > kRatio * image &&
           background > kContrast * kContrast * ends;
  }
};

double acrossInImage(const cv::Mat& image, int y, int inside, int outside) {
  const int channels = image.channels();
  const uint8_t* row = image.ptr(y);
  double sum = 0;
  for (int c = 0; c < channels; ++c) {
    const double off = double(row[inside * channels + c]) - double(row[outside * channels + c]);
    sum += off * off;
  }
  return sum;
}

double acrossInBackground(const Background& background, int y, int inside, int outside) {
  double sum = 0;
  for (int c = 0; c < background.channels(); ++c) {
    const uint16_t* row = background.mean(0, y, c);
    const double off = (double(row[inside]) - double(row[outside])) / Background::kMeanScale;
    sum += off * off;
  }
  return sum;
}

/// The ends of the runs where the mask ends, too.
Outline outlineOf(const std::vector<MaskRun>& runs, const cv::Mat& image,
                  const Background& background, const BitMask& mask) {
  Outline outline;
  const auto add = [&](int y, int inside, int next, int outside) {
    if (outside < 0 || outside >= mask.cols() || mask.at(next, y) || mask.at(outside, y)) return;
    if (background.isUnknown(inside, y)) return;
    ++outline.ends;
    outline.image += acrossInImage(image, y, inside, outside);
    outline.background += acrossInBackground(background, y, inside, outside);
  };
  for (const MaskRun& run : runs) {
    if (run.last - run.first < kBeside) continue;
    add(run.y, run.first + kBeside - 1, run.first - 1, run.first - kBeside);
    add(run.y, run.last - kBeside + 1, run.last + 1, run.last + kBeside);
  }
  return outline;
}

/// Whether any part of the mask may be a ghost: with part of its outline, as a person may stand
/// before the rest.
bool isAnySuspect(const cv::Mat& image, const Background& background, const BitMask& mask) {
  for (const std::vector<MaskRun>& component : findBlobs(std::numeric_limits<int>::max(), mask)) {
    int ghostly = 0;
    for (const MaskRun& run : component) {
      Outline end = outlineOf({run}, image, background, mask);
      if (end.ends > 0 && end.background > kContrast * kContrast * end.ends &&
          end.background > kRatio * end.image)
        ghostly += end.ends;
    }
    if (ghostly >= kFewestEnds) return true;
  }
  return false;
}

void absorb(const BitMask& place, const StillImages& images, Background* background) {
  for (int y = 0; y < images.now.rows; ++y) {
    bool any = false;
    for (int i = 0; i < place.rowWords(); ++i)
      forEachBit(place.row(y)[i], 64 * i, [&](int x) {
        any = true;
        for (int c = 0; c < background->channels(); ++c)
          background->mean(0, y, c)[x] = images.mean(x, y, c);
      });
    if (any) background->updateQuantised(0, y);
  }
}

}  // namespace

size_t UncoveredPlaces::update(const cv::Mat& image, double gain, Background* background,
                               BitMask* mask) {
  if (images_++ % kStep != 0) return 0;
  if (!isAnySuspect(image, *background, *mask)) {
    previous_.release();
    return 0;
  }
  size_t uncovered = 0;
  if (!previous_.empty()) {
    const BitMask still = stillPart(image, gain, *background, *mask);
    BitMask place({mask->cols(), mask->rows()});
    for (const std::vector<MaskRun>& part : findBlobs(std::numeric_limits<int>::max(), still))
      if (outlineOf(part, image, *background, *mask).isGhost()) fillRuns(part, &place);
    uncovered = place.count();
    if (uncovered > 0)
      absorb(takeOut(place, kBlur, mask), {image, gain, previous_, previous_gain_}, background);
  }
  image.copyTo(previous_);
  previous_gain_ = gain;
  return uncovered;
}

BitMask UncoveredPlaces::stillPart(const cv::Mat& image, double gain, const Background& background,
                                   const BitMask& mask) const {
  const int channels = image.channels();
  const float limit = float(kNoiseVariances * background.noise() * background.noise());
  const float per_gain = float(1 / gain), per_gain_then = float(1 / previous_gain_);
  BitMask moving({mask.cols(), mask.rows()});
  for (int y = 0; y < image.rows; ++y) {
    const uint8_t* now = image.ptr(y);
    const uint8_t* then = previous_.ptr(y);
    for (int i = 0; i < mask.rowWords(); ++i)
      forEachBit(mask.row(y)[i], 64 * i, [&](int x) {
        const ptrdiff_t at = ptrdiff_t(x) * channels;
        if (squaredDistance(now + at, per_gain, then + at, per_gain_then, channels) > limit)
          moving.set(x, y);
      });
  }
  BitMask still = mask;
  still.remove(dilated(moving, kBlur));
  still.remove(background.unknown());
  return still;
}

}  // namespace markerless_mocap
