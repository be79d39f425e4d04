#include "silhouette/boundary/boundary_matting.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "silhouette/bits/bit_morphology.h"

namespace markerless_mocap {
namespace {

constexpr int kSide = kMattingBlock;
/// Minimum squared contrast of person and background, per channel; below it noise would decide.
constexpr float kMinContrast = 15;
/// Position of a block relative to the boundary.
constexpr uint8_t kFar = 0, kNearBoundary = 1, kOnBoundary = 2;

/// The four bits of a block's row.
unsigned nibble(const BitMask& mask, int x, int y) {
  return unsigned(mask.row(y)[x >> 6] >> (x & 63)) & 15u;
}

int countOf(BlockBits bits) {
  constexpr uint8_t kCounts[] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
  return kCounts[bits & 15] + kCounts[bits >> 4 & 15] + kCounts[bits >> 8 & 15] +
         kCounts[bits >> 12];
}

/// The mask's bits of the block whose upper left pixel is x, y; 0 outside the image.
BlockBits blockOf(const BitMask& mask, int x, int y) {
  unsigned bits = 0;
  for (int i = std::min(kSide, mask.rows() - y) - 1; i >= 0; --i)
    bits = bits << kSide | nibble(mask, x, y + i);
  return BlockBits(bits);
}

/// The pixels of such a block that are inside the image.
BlockBits validBits(const cv::Mat& image, int x, int y) {
  const int beyond_x = std::max(0, x + kSide - image.cols);
  const int beyond_y = std::max(0, y + kSide - image.rows);
  return BlockBits((15u >> beyond_x) * 0x1111u & (0xffffu >> (kSide * beyond_y)));
}

/// Brightness of a pixel relative to the background's, 255 for 1. Sums over a block and its
/// neighbours fit into 16 bits.
int litRatio(const cv::Mat& image, const Background& background, float gain, int x, int y) {
  constexpr int kLargest = 446;
  const ModeRow mode = background.quantised(0, y);
  int now = 0, expected = 0;
  for (int c = 0; c < image.channels(); ++c) {
    now += image.ptr(y)[x * image.channels() + c];
    expected += mode.mean[c][x];
  }
  return int(std::min(float(kLargest), 255 * float(now) / (gain * float(std::max(expected, 1)))));
}

/// Calls `visit(x, y)` for each of such a block's pixels.
template <class VisitT>
void forEachPixel(BlockBits bits, int x, int y, const VisitT& visit) {
  forEachBit(bits, 0, [&](int i) { visit(x + i % kSide, y + i / kSide); });
}

}  // namespace

void BoundaryMatting::refine(const cv::Mat& image, const Background& background, double gain,
                             const PixelClasses& classes, BitMask* mask) {
  const Scene scene{image, background, float(gain), classes};
  columns_ = (image.cols + kSide - 1) / kSide;
  rows_ = (image.rows + kSide - 1) / kSide;
  stride_ = columns_ * kSide;
  alpha_.resize(size_t(stride_) * image.rows);
  core_ = eroded(*mask, 1);
  // The band that is decided again is four pixels wide, the reach of blur and chroma subsampling.
  outer_ = dilated(dilated(*mask, 1), 1);
  band_ = outer_;
  band_.remove(eroded(core_, 1));
  findBlocks();
  for (const Block& block : blocks_) {
    sumBlock(scene, block.column, block.row);
    presetBlock(*mask, block.column, block.row);
  }
  for (const Block& block : blocks_)
    if (kind_[size_t(block.row) * columns_ + block.column] == kOnBoundary)
      estimateBlock(scene, around(block.column, block.row), block.column, block.row);
  smooth(mask);
}

void BoundaryMatting::findBlocks() {
  kind_.assign(size_t(columns_) * rows_, kFar);
  blocks_.clear();
  const auto mark = [this](int column, int row, uint8_t kind) {
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
    uint8_t& known = kind_[size_t(row) * columns_ + column];
    if (known == kFar) blocks_.push_back({column, row});
    known = std::max(known, kind);
  };
  for (int y = 0; y < band_.rows(); ++y)
    for (int i = 0; i < band_.rowWords(); ++i)
      for (uint64_t word = band_.row(y)[i]; word;) {
        const int nth = __builtin_ctzll(word) / kSide;
        word &= ~(uint64_t(15) << (kSide * nth));
        const int column = i * (64 / kSide) + nth, row = y / kSide;
        if (kind_[size_t(row) * columns_ + column] == kOnBoundary) continue;
        for (int v = row - 1; v <= row + 1; ++v)
          for (int u = column - 1; u <= column + 1; ++u) mark(u, v, kNearBoundary);
        mark(column, row, kOnBoundary);
      }
  sums_.resize(kind_.size());
}

void BoundaryMatting::presetBlock(const BitMask& mask, int column, int row) {
  const int x = column * kSide;
  for (int y = row * kSide; y < std::min((row + 1) * kSide, mask.rows()); ++y) {
    // The product moves each bit to a byte of its own.
    const uint32_t flags = nibble(mask, x, y) * 0x00204081u & 0x01010101u;
    const uint32_t bytes = flags * 255;
    std::memcpy(&alpha_[size_t(y) * stride_ + x], &bytes, kSide);
  }
}

bool BoundaryMatting::canUseKernels(const Scene& scene, int x, int y) {
  return hasMattingKernels() && scene.image.channels() == 3 &&
         validBits(scene.image, x, y) == 0xffffu;
}

ColorBlock BoundaryMatting::colorBlock(const Scene& scene, int x, int y) {
  const ModeRow mode = scene.background.quantised(0, y);
  return {scene.image.ptr(y) + 3 * size_t(x),
          ptrdiff_t(scene.image.step),
          {mode.mean[0] + x, mode.mean[1] + x, mode.mean[2] + x},
          scene.background.quantisedStep()};
}

void BoundaryMatting::sumBlock(const Scene& scene, int column, int row) {
  const int channels = scene.image.channels(), x0 = column * kSide, y0 = row * kSide;
  Sums& sums = sums_[size_t(row) * columns_ + column];
  sums = Sums();
  const BlockBits inside = blockOf(core_, x0, y0);
  const BlockBits outside = validBits(scene.image, x0, y0) & BlockBits(~blockOf(outer_, x0, y0));
  const BlockBits shadow = outside & blockOf(scene.classes.shadow, x0, y0);
  sums.inside = uint16_t(countOf(inside));
  sums.outside = uint16_t(countOf(outside));
  sums.light = uint16_t(255 * (sums.outside - countOf(shadow)));
  forEachPixel(shadow, x0, y0, [&](int x, int y) {
    sums.light += scene.classes.ratio[size_t(y) * scene.background.stride() + x];
  });
  if (scene.classes.lit.rows() > 0)
    forEachPixel(outside & blockOf(scene.classes.lit, x0, y0), x0, y0, [&](int x, int y) {
      sums.light =
          uint16_t(sums.light + litRatio(scene.image, scene.background, scene.gain, x, y) - 255);
    });
  if (!inside) return;
  if (canUseKernels(scene, x0, y0))
    addColors(colorBlock(scene, x0, y0), inside, sums.color);
  else
    forEachPixel(inside, x0, y0, [&](int x, int y) {
      for (int c = 0; c < channels; ++c) sums.color[c] += scene.image.ptr(y)[x * channels + c];
    });
}

BoundaryMatting::Sums BoundaryMatting::around(int column, int row) const {
  Sums sum;
  for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y)
    for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
      const Sums& one = sums_[size_t(y) * columns_ + x];
      for (int c = 0; c < 3; ++c) sum.color[c] += one.color[c];
      sum.inside += one.inside;
      sum.light += one.light;
      sum.outside += one.outside;
    }
  return sum;
}

void BoundaryMatting::estimateBlock(const Scene& scene, const Sums& around, int column, int row) {
  if (around.inside == 0) return;
  const int channels = scene.image.channels(), x0 = column * kSide, y0 = row * kSide;
  const float light =
      around.outside > 0 ? float(around.light) / (255 * float(around.outside)) : 1.0f;
  const float noise = float(scene.background.noise());
  MattingColors colors{
      {}, scene.gain * light, noise * noise * float(channels), kMinContrast * float(channels)};
  for (int c = 0; c < channels; ++c) colors.person[c] = float(around.color[c]) / around.inside;
  const BlockBits selected = blockOf(band_, x0, y0);
  if (canUseKernels(scene, x0, y0))
    estimateAlpha(colorBlock(scene, x0, y0), colors, selected, stride_,
                  &alpha_[size_t(y0) * stride_ + x0]);
  else
    forEachPixel(selected, x0, y0, [&](int x, int y) { estimatePixel(scene, colors, x, y); });
}

void BoundaryMatting::estimatePixel(const Scene& scene, const MattingColors& colors, int x, int y) {
  const int channels = scene.image.channels();
  const ModeRow mode = scene.background.quantised(0, y);
  float apart = 0, contrast = 0;
  for (int c = 0; c < channels; ++c) {
    const float lit = float(mode.mean[c][x]) * colors.light;
    const float off = float(scene.image.ptr(y)[x * channels + c]) - lit;
    const float whole = colors.person[c] - lit;
    apart += off * off;
    contrast += whole * whole;
  }
  if (contrast < colors.min_contrast) return;
  const float square = (apart - colors.squared_noise) / contrast;
  const float alpha = std::sqrt(std::min(1.0f, std::max(0.0f, square)));
  alpha_[size_t(y) * stride_ + x] = uint8_t(int(255 * alpha));
}

/// Smooths the boundary: a pixel is set if more than half of the alpha around it is the person's.
void BoundaryMatting::smooth(BitMask* mask) const {
  constexpr int kHalf = 255 * 25 / 2;
  const auto line = [](const uint8_t* at) { return at[-1] + 3 * at[0] + at[1]; };
  for (int y = 1; y + 1 < mask->rows(); ++y)
    for (int i = 0; i < mask->rowWords(); ++i)
      forEachBit(band_.row(y)[i], 64 * i, [&](int x) {
        if (x == 0 || x + 1 == mask->cols()) return;
        const uint8_t* at = &alpha_[size_t(y) * stride_ + x];
        const bool is_person = line(at - stride_) + 3 * line(at) + line(at + stride_) > kHalf;
        if (is_person != mask->at(x, y)) mask->flip(x, y);
      });
}

}  // namespace markerless_mocap
