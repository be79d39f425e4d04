#include "silhouette/background/pixel_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "silhouette/background/row_kernels.h"
#include "silhouette/bits/bit_morphology.h"
#include "silhouette/bits/changed_bits.h"
#include "silhouette/shadow/pixel_shadow.h"
#include "silhouette/shadow/shadow_kernels.h"

namespace markerless_mocap {
namespace {

/// Squared distance of a shadow's colour from the background's that noise may cause, in variances.
/// It has two degrees of freedom; nine in ten values are below this.
constexpr float kNoiseVariances = 4.6f;

BlockShadowThresholds makeLimits(const SilhouetteOptions& options, const Background& background,
                                 double gain) {
  const double chroma = options.shadow_chroma_tolerance, noise = background.noise();
  return {background.channels() == 1, float(gain), float(chroma), float(noise * noise)};
}

}  // namespace

void splitRow(const cv::Mat& image, int y, int first, int count, int stride, uint8_t* planes) {
  if (image.channels() == 3)
    deinterleaveBgr(image.ptr(y) + 3 * size_t(first), count, stride, planes);
  else
    std::memcpy(planes, image.ptr(y) + first, count);
}

void PixelTest::prepare(const Background& background) {
  const cv::Size size = background.size();
  const size_t stride = background.stride();
  classes_.foreground.resize(size);
  classes_.shadow.resize(size);
  classes_.lit = BitMask();
  classes_.ratio.resize(size.height * stride);
  blocks_.resize(size);
  now_.resize(3 * stride);
  flags_.resize(stride);
  squared_.resize(stride);
  other_.resize(stride);
}

PixelClasses& PixelTest::classify(const SilhouetteOptions& options, const cv::Mat& image,
                                  const Background& background, double gain) {
  options_ = options;
  prepare(background);
  findChanged(image, background, gain);
  // Noise that the following opening will remove is not examined.
  const int radius = options_.open_radius_px;
  classes_.foreground = dilated(eroded(classes_.foreground, radius), radius);
  classes_.changed = classes_.foreground.count();
  if (!options_.remove_shadows) return classes_;
  for (int row = 0; row < blocks_.rows(); ++row) findShadows(image, background, gain, row);
  classes_.foreground.remove(classes_.shadow);
  const BlockShadowThresholds limits = makeLimits(options_, background, gain);
  restoreFalseShadows(blocks_, limits, &classes_.shadow, &classes_.foreground);
  return classes_;
}

void PixelTest::findChanged(const cv::Mat& image, const Background& background, double gain) {
  wanted_.assign(classes_.foreground.rowWords(), 1);
  if (options_.open_radius_px == 0) {
    findChangedRows(image, background, gain, 0, 1);
    return;
  }
  findChangedRows(image, background, gain, 0, 4);
  findChangedRows(image, background, gain, 2, 4);
  findChangedRows(image, background, gain, 1, 2);
}

void PixelTest::findChangedRows(const cv::Mat& image, const Background& background, double gain,
                                int first, int step) {
  for (int y = first; y < image.rows; y += step) {
    if (first > 0) selectWords(y, step / 2);
    findChanged(image, background, gain, y, y + step < image.rows ? step : 0);
  }
}

void PixelTest::selectWords(int y, int apart) {
  const BitMask& mask = classes_.foreground;
  const int words = mask.rowWords();
  const uint64_t* above = mask.row(y - apart);
  const uint64_t* below = y + apart < mask.rows() ? mask.row(y + apart) : above;
  const uint64_t last_column = mask.tailBits() & ~(mask.tailBits() >> 1);
  // What remains after the opening consists of crosses. A cross that touches this row has its
  // centre here, and then pixels above and below, or its centre in the row above or below, and then
  // three pixels in a row there. For rows that are further apart only three in a row count, as
  // noise often occurs twice.
  const auto centers = [&](int i) {
    if (i >= words) return uint64_t(0);
    const auto three = [&](const uint64_t* row) {
      const uint64_t left = i > 0 ? row[i - 1] >> 63 : 1;
      const uint64_t right = i + 1 < words ? row[i + 1] << 63 : last_column;
      return row[i] & (row[i] << 1 | left) & (row[i] >> 1 | right);
    };
    return (apart == 1 ? above[i] & below[i] : 0) | three(above) | three(below);
  };
  uint64_t left = 0, here = centers(0);
  for (int i = 0; i < words; ++i) {
    const uint64_t right = centers(i + 1);
    wanted_[i] = here | (apart == 1 ? left >> 63 | right << 63 : left | right);
    left = here;
    here = right;
  }
}

void PixelTest::findChanged(const cv::Mat& image, const Background& background, double gain, int y,
                            int rows_ahead) {
  const int n = background.stride(), channels = background.channels();
  const int16_t fixed_gain = int16_t(std::lround(gain * kGainOne));
  constexpr uint16_t kSquaredLimit = Background::kLimit * Background::kLimit;
  uint64_t* bits = classes_.foreground.row(y);
  if (channels == 3) {
    std::array<ModeRow, Background::kMaxModes> modes;
    for (int mode = 0; mode < background.modes(); ++mode)
      modes[mode] = background.quantised(mode, y);
    const RowsAhead ahead{ptrdiff_t(image.step) * rows_ahead,
                          background.quantisedStep() * rows_ahead};
    if (changedBits(image.ptr(y), image.cols, modes.data(), background.modes(), fixed_gain,
                    kSquaredLimit, ahead, wanted_.data(), bits))
      return;
  }
  splitRow(image, y, 0, image.cols, n, now_.data());
  const uint8_t* now[] = {&now_[0], &now_[n], &now_[2 * size_t(n)]};
  for (int mode = 0; mode < background.modes(); ++mode) {
    squaredDistances(now, background.quantised(mode, y), channels, fixed_gain, n,
                     mode == 0 ? squared_.data() : other_.data());
    if (mode > 0) keepSmaller(other_.data(), n, squared_.data());
  }
  packAbove(squared_.data(), kSquaredLimit, n, flags_.data(), bits);
}

void PixelTest::findShadows(const cv::Mat& image, const Background& background, double gain,
                            int row) {
  const int first = row * ShadowBlocks::kSide;
  const int end = std::min(first + ShadowBlocks::kSide, image.rows);
  for (int word = 0; word < classes_.foreground.rowWords(); ++word) {
    uint64_t any = 0;
    for (int y = first; y < end; ++y) any |= classes_.foreground.row(y)[word];
    if (!any) continue;
    ShadowColumns columns;
    bool is_shaded = false;
    for (int y = first; y < end; ++y)
      is_shaded |= findShadows(image, background, gain, y, word, &columns);
    if (is_shaded) blocks_.add(columns, word, row);
  }
}

bool PixelTest::findShadows(const cv::Mat& image, const Background& background, double gain, int y,
                            int word, ShadowColumns* columns) {
  constexpr int kWord = ShadowColumns::kCols;
  const uint64_t changed = classes_.foreground.row(y)[word];
  if (!changed) return false;
  const float chroma = float(options_.shadow_chroma_tolerance), noise = float(background.noise());
  const PixelShadowThresholds limits{float(options_.min_shadow_brightness), chroma * chroma,
                                     kNoiseVariances * noise * noise};
  const int x = kWord * word, width = std::min(kWord, image.cols - x);
  const ModeRow mode = background.quantised(0, y);
  uint64_t* shadow = &classes_.shadow.row(y)[word];
  uint8_t* ratio = &classes_.ratio[size_t(y) * background.stride() + x];
  if (background.channels() == 3) {
    const uint8_t* bgr = image.ptr(y) + 3 * size_t(x);
    uint8_t rest[3 * kWord] = {};
    if (width < kWord) bgr = static_cast<uint8_t*>(std::memcpy(rest, bgr, 3 * size_t(width)));
    if (shadowRatiosOfBgr(bgr, mode, x, float(gain), limits, changed, ratio, shadow, columns))
      return *shadow != 0;
  }
  const uint8_t* now[] = {&now_[0], &now_[kWord], &now_[size_t(2) * kWord]};
  splitRow(image, y, x, width, kWord, now_.data());
  unpackBits(&changed, kWord, flags_.data());
  shadowRatios(now, mode, x, background.channels(), float(gain), limits, flags_.data(), ratio,
               columns);
  for (int k = 0; k < kWord; ++k) flags_[k] = ratio[k] > 0;
  *shadow = packFlags(flags_.data());
  return *shadow != 0;
}

}  // namespace markerless_mocap
