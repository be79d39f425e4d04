#include "silhouette/pixel_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "silhouette/bit_morphology.h"
#include "silhouette/changed_bits.h"
#include "silhouette/row_kernels.h"

namespace markerless_mocap {
namespace {

/// A shade's squared distance from its background's colour that noise may cause, in variances: two
/// of the three channels' directions are free, of which nine in ten stay within.
constexpr float kNoiseVariances = 4.6f;

ShadowLimits makeLimits(const SilhouetteOptions& options, const Background& background,
                        double gain) {
  const double chroma = options.shadow_chroma_tolerance, noise = background.noise();
  return {background.channels() == 1, float(gain), float(chroma), float(noise * noise)};
}

}  // namespace

void splitRow(const cv::Mat& image, int y, int first, int count, int stride, uint8_t* planes) {
  if (image.channels() == 3)
    splitThree(image.ptr(y) + 3 * size_t(first), count, stride, planes);
  else
    std::memcpy(planes, image.ptr(y) + first, count);
}

PixelTest::PixelTest(const SilhouetteOptions& options) : options_(options) {}

void PixelTest::prepare(const Background& background) {
  const cv::Size size = background.size();
  const size_t stride = background.stride();
  classes_.foreground.resize(size);
  classes_.shade.resize(size);
  classes_.ratio.resize(size.height * stride);
  blocks_.resize(size);
  now_.resize(3 * stride);
  flags_.resize(stride);
  squared_.resize(stride);
  other_.resize(stride);
}

const PixelClasses& PixelTest::classify(const cv::Mat& image, const Background& background,
                                        double gain) {
  prepare(background);
  for (int y = 0; y < image.rows; ++y) classifyRow(image, background, gain, y);
  // Noise is not worth a closer look: it would not outlive the opening that follows.
  const int radius = options_.open_radius_px;
  classes_.foreground = dilated(eroded(classes_.foreground, radius), radius);
  classes_.changed = classes_.foreground.count();
  if (!options_.remove_shadows) return classes_;
  for (int row = 0; row < blocks_.rows(); ++row) findShades(image, background, gain, row);
  for (size_t i = 0; i < classes_.shade.words().size(); ++i)
    classes_.foreground.words()[i] &= ~classes_.shade.words()[i];
  const ShadowLimits limits = makeLimits(options_, background, gain);
  restoreClothes(blocks_, limits, &classes_.shade, &classes_.foreground);
  return classes_;
}

void PixelTest::classifyRow(const cv::Mat& image, const Background& background, double gain,
                            int y) {
  const int n = background.stride(), channels = background.channels();
  const int16_t fixed_gain = int16_t(std::lround(gain * kGainOne));
  constexpr uint16_t kSquaredLimit = Background::kLimit * Background::kLimit;
  uint64_t* bits = classes_.foreground.row(y);
  if (channels == 3) {
    std::array<ModeRow, Background::kMostModes> modes;
    for (int mode = 0; mode < background.modes(); ++mode) modes[mode] = background.coarse(mode, y);
    if (changedBits(image.ptr(y), image.cols, modes.data(), background.modes(), fixed_gain,
                    kSquaredLimit, bits))
      return;
  }
  splitRow(image, y, 0, image.cols, n, now_.data());
  const uint8_t* now[] = {&now_[0], &now_[n], &now_[2 * size_t(n)]};
  for (int mode = 0; mode < background.modes(); ++mode) {
    squaredDistances(now, background.coarse(mode, y), channels, fixed_gain, n,
                     mode == 0 ? squared_.data() : other_.data());
    if (mode > 0) keepSmaller(other_.data(), n, squared_.data());
  }
  packAbove(squared_.data(), kSquaredLimit, n, flags_.data(), bits);
}

void PixelTest::findShades(const cv::Mat& image, const Background& background, double gain,
                           int row) {
  const int first = row * ShadeBlocks::kSide;
  const int end = std::min(first + ShadeBlocks::kSide, image.rows);
  for (int word = 0; word < classes_.foreground.rowWords(); ++word) {
    ShadeColumns columns;
    bool any = false;
    for (int y = first; y < end; ++y) any |= findShades(image, background, gain, y, word, &columns);
    if (any) blocks_.add(columns, word, row);
  }
}

bool PixelTest::findShades(const cv::Mat& image, const Background& background, double gain, int y,
                           int word, ShadeColumns* columns) {
  constexpr int kWord = ShadeColumns::kCols;
  const uint64_t changed = classes_.foreground.row(y)[word];
  if (!changed) return false;
  const float chroma = float(options_.shadow_chroma_tolerance), noise = float(background.noise());
  const ShadeLimits limits{float(options_.shadow_darkest), chroma * chroma,
                           kNoiseVariances * noise * noise};
  const int x = kWord * word;
  const uint8_t* now[] = {&now_[0], &now_[kWord], &now_[2 * kWord]};
  splitRow(image, y, x, std::min(kWord, image.cols - x), kWord, now_.data());
  unpackBits(&changed, kWord, flags_.data());
  uint8_t* ratio = &classes_.ratio[size_t(y) * background.stride() + x];
  shadeRatios(now, background.coarse(0, y), x, background.channels(), float(gain), limits,
              flags_.data(), ratio, columns);
  for (int k = 0; k < kWord; ++k) flags_[k] = ratio[k] > 0;
  classes_.shade.row(y)[word] = packFlags(flags_.data());
  return classes_.shade.row(y)[word] != 0;
}

}  // namespace markerless_mocap
