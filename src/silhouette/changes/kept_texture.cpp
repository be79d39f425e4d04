#include "silhouette/changes/kept_texture.h"

#include <algorithm>
#include <cmath>

#include "silhouette/image_cycle.h"

namespace markerless_mocap {
namespace {

constexpr int kSide = 8;  ///< of a block, px
/// While no such light is seen, one image in this many is searched for it.
constexpr int kSearchStep = 12;
static_assert(kImageCycle % kSearchStep == 0);
/// All images are searched at first, and for so many after it was seen.
constexpr int kKeepSearching = 24;
/// Number of blocks that must show the texture, as a few may by chance.
constexpr int kFewestBlocks = 8;
constexpr float kFewestPixels = 48;
/// Variance of the texture in the image, per channel, in variances of the noise, at least.
constexpr float kMinTexture = 2;
/// Variance that the texture leaves unexplained, in variances of the noise and as a fraction of the
/// texture's, at most.
constexpr float kMaxNoise = 1.5f, kMaxUnexplained = 0.12f;
/// Contrast of the texture, relative to that of a change of light, and to the background's.
constexpr float kMinContrast = 0.6f, kMaxContrast = 1.5f, kMaxMirrored = 1.15f;
/// Distance of a pixel from its expected colour, in standard deviations of noise and relative, at
/// most.
constexpr float kNoiseDeviations = 4, kRelative = 0.06f;
/// Brighter channels of a pixel are clipped, or near it.
constexpr float kClipped = 248;
/// Number of pixels, each counted in up to nine blocks, from which light is learned.
constexpr float kFewestLit = 1500;
/// Light is remembered if it changes the brightness by more than this fraction.
constexpr float kClearLight = 0.2f;
/// A pixel's change of light, relative to the remembered mean, at most.
constexpr float kStrongestLight = 1.3f;

}  // namespace

void KeptTexture::Sums::add(const float* expected, const float* now, int channels) {
  for (int c = 0; c < channels; ++c) {
    if (now[c] > kClipped || expected[c] > kClipped) continue;
    ++n[c];
    m[c] += expected[c];
    i[c] += now[c];
    mm[c] += expected[c] * expected[c];
    mi[c] += expected[c] * now[c];
    ii[c] += now[c] * now[c];
  }
}

void KeptTexture::Sums::add(const Sums& other) {
  for (int c = 0; c < 3; ++c) {
    n[c] += other.n[c];
    m[c] += other.m[c];
    i[c] += other.i[c];
    mm[c] += other.mm[c];
    mi[c] += other.mi[c];
    ii[c] += other.ii[c];
  }
}

void KeptTexture::findLit(const cv::Mat& image, const Background& background, double gain,
                          PixelClasses* classes) {
  ++images_;
  const bool is_seen = last_found_ >= 0 && images_ - last_found_ <= kKeepSearching;
  if (!is_seen && images_ > kKeepSearching && images_ % kSearchStep != 0) return;
  squared_noise_ = float(background.noise() * background.noise());
  sumBlocks(image, background, float(gain), classes->foreground);
  if (relateBlocks(image.channels()) >= kFewestBlocks) last_found_ = images_;
  if (is_seen || last_found_ == images_) moveLit(image, background, float(gain), classes);
}

int KeptTexture::relateBlocks(int channels) {
  int sure = 0;
  for (int side = 0; side < 2; ++side) {
    Sums lit;
    for (const int block : filled_[side]) {
      const Sums sums = around(sums_[side], block % columns_, block / columns_);
      relations_[side][block] = relationOf(sums, channels);
      if (!relations_[side][block].is_sure) continue;
      ++sure;
      if (std::abs(sums.i[0] / sums.m[0] - 1) > kClearLight) lit.add(sums);
    }
    if (lit.n[0] < kFewestLit) continue;
    light_[side].is_sure = true;
    for (int c = 0; c < channels; ++c) light_[side].slope[c] = lit.i[c] / std::max(lit.m[c], 1.0f);
  }
  for (int side = 0; side < 2; ++side)
    if (!light_[side].is_sure && light_[1 - side].is_sure)
      for (int c = 0; c < channels; ++c)
        light_[side].slope[c] = 1 / std::max(light_[1 - side].slope[c], 0.1f);
  return sure;
}

void KeptTexture::clearBlocks() {
  for (int side = 0; side < 2; ++side) {
    for (const int block : filled_[side]) {
      sums_[side][block] = Sums();
      relations_[side][block] = Relation();
    }
    filled_[side].clear();
    sums_[side].resize(size_t(columns_) * rows_);
    relations_[side].resize(size_t(columns_) * rows_);
  }
}

void KeptTexture::sumBlocks(const cv::Mat& image, const Background& background, float gain,
                            const BitMask& foreground) {
  columns_ = (image.cols + kSide - 1) / kSide;
  rows_ = (image.rows + kSide - 1) / kSide;
  clearBlocks();
  const int channels = image.channels();
  for (int y = 0; y < image.rows; ++y) {
    const ModeRow mode = background.quantised(0, y);
    const uint8_t* row = image.ptr(y);
    const size_t first = size_t(y / kSide) * columns_;
    for (int k = 0; k < foreground.rowWords(); ++k)
      forEachBit(foreground.row(y)[k], 64 * k, [&](int x) {
        float i[3], m[3], brighter = 0;
        for (int c = 0; c < channels; ++c) {
          i[c] = row[x * channels + c];
          m[c] = gain * mode.mean[c][x];
          brighter += i[c] - m[c];
        }
        const size_t block = first + x / kSide;
        Sums& sums = sums_[brighter > 0][block];
        if (!sums.is_filled) filled_[brighter > 0].push_back(int(block));
        sums.is_filled = true;
        sums.add(m, i, channels);
      });
  }
}

KeptTexture::Sums KeptTexture::around(const std::vector<Sums>& blocks, int column, int row) const {
  Sums sum;
  for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y)
    for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x)
      sum.add(blocks[size_t(y) * columns_ + x]);
  return sum;
}

KeptTexture::Relation KeptTexture::relationOf(const Sums& sums, int channels) const {
  Relation relation;
  float texture = 0, common = 0, seen = 0, all_m = 0, all_i = 0, samples = 0;
  for (int c = 0; c < channels; ++c) {
    if (sums.n[c] < kFewestPixels) return relation;
    const float var = sums.mm[c] - sums.m[c] * sums.m[c] / sums.n[c];
    const float cov = sums.mi[c] - sums.m[c] * sums.i[c] / sums.n[c];
    const float light = sums.i[c] / std::max(sums.m[c], 1.0f);
    // Where there is little texture, as if it were a change of light.
    const float prior = 4 * squared_noise_ * sums.n[c];
    relation.slope[c] = (cov + prior * light) / (var + prior);
    relation.offset[c] = (sums.i[c] - relation.slope[c] * sums.m[c]) / sums.n[c];
    texture += var;
    common += cov;
    seen += sums.ii[c] - sums.i[c] * sums.i[c] / sums.n[c];
    all_m += sums.m[c];
    all_i += sums.i[c];
    samples += sums.n[c];
  }
  if (common <= 0) return relation;
  const float slope = common / texture, light = all_i / all_m, explained = slope * common;
  const bool is_light = slope > kMinContrast * light && slope < kMaxContrast * light;
  const bool is_mirror = slope > kMinContrast && slope < kMaxMirrored;
  relation.is_sure =
      (is_light || is_mirror) && explained > kMinTexture * squared_noise_ * samples &&
      seen - explained < kMaxNoise * squared_noise_ * samples + kMaxUnexplained * explained;
  return relation;
}

bool KeptTexture::explains(const Relation& relation, const float* now, const float* expected,
                           int channels, float most) const {
  // The border of a patch is soft: all between the background and the lit background is right.
  float change[3], cross = 0, square = 1e-6f, off = 0, grey = 0;
  for (int c = 0; c < channels; ++c) {
    change[c] = relation.offset[c] + (relation.slope[c] - 1) * expected[c];
    grey += now[c];
    if (now[c] > kClipped || expected[c] > kClipped) continue;
    cross += change[c] * (now[c] - expected[c]);
    square += change[c] * change[c];
  }
  const float part = std::clamp(cross / square, 0.0f, most);
  for (int c = 0; c < channels; ++c) {
    const float lit = expected[c] + part * change[c];
    const bool both_clipped = now[c] > kClipped && lit > kClipped;
    const bool was_clipped = expected[c] > kClipped && now[c] > lit;
    if (!both_clipped && !was_clipped) off += (now[c] - lit) * (now[c] - lit);
  }
  const float relative = kRelative * grey / float(channels);
  return off < kNoiseDeviations * kNoiseDeviations * squared_noise_ + relative * relative;
}

bool KeptTexture::isLit(const float* now, const float* expected, int channels, bool brighter,
                        int column, int row) const {
  if ((light_[0].is_sure || light_[1].is_sure) &&
      explains(light_[brighter], now, expected, channels, kStrongestLight))
    return true;
  for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y)
    for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
      const Relation& relation = relations_[brighter][size_t(y) * columns_ + x];
      if (relation.is_sure && explains(relation, now, expected, channels, 1)) return true;
    }
  return false;
}

void KeptTexture::moveLit(const cv::Mat& image, const Background& background, float gain,
                          PixelClasses* classes) const {
  classes->lit.resize(image.size());
  BitMask* foreground = &classes->foreground;
  const int channels = image.channels();
  for (int y = 0; y < image.rows; ++y) {
    const ModeRow mode = background.quantised(0, y);
    const uint8_t* row = image.ptr(y);
    for (int k = 0; k < foreground->rowWords(); ++k) {
      uint64_t lit = 0;
      forEachBit(foreground->row(y)[k], 0, [&](int bit) {
        const int x = 64 * k + bit;
        float now[3], expected[3], brighter = 0;
        for (int c = 0; c < channels; ++c) {
          now[c] = row[x * channels + c];
          expected[c] = gain * mode.mean[c][x];
          brighter += now[c] - expected[c];
        }
        if (isLit(now, expected, channels, brighter > 0, x / kSide, y / kSide))
          lit |= uint64_t(1) << bit;
      });
      foreground->row(y)[k] &= ~lit;
      classes->lit.row(y)[k] = lit;
    }
  }
}

}  // namespace markerless_mocap
