#include "silhouette/rim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "silhouette/bit_morphology.h"

namespace markerless_mocap {
namespace {

/// Half the width of what is decided anew, px: blur and chroma subsampling reach so far.
constexpr int kReach = 2;
/// Side of the blocks in which colours are summed, px.
constexpr int kSide = 4;
/// Squared contrast of person and background, per channel, under which noise would decide.
constexpr float kLeastContrast = 15;
/// Where a block lies.
constexpr uint8_t kFar = 0, kNearRim = 1, kOnRim = 2;

/// The four bits of a block's row.
unsigned nibble(const BitMask& mask, int x, int y) {
  return unsigned(mask.row(y)[x >> 6] >> (x & 63)) & 15u;
}

unsigned countOf(unsigned nibble) {
  constexpr uint8_t kCounts[] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
  return kCounts[nibble];
}

/// The bytes, 0 | 255, of each nibble's four pixels of three channels, in two words.
using ByteMasks = std::array<std::array<uint64_t, 2>, 16>;

constexpr ByteMasks makeByteMasks() {
  ByteMasks masks{};
  for (int nibble = 0; nibble < 16; ++nibble)
    for (int i = 0; i < 3 * kSide; ++i)
      if (nibble >> i / 3 & 1) masks[nibble][i / 8] |= uint64_t(255) << (8 * (i % 8));
  return masks;
}

constexpr ByteMasks kByteMasks = makeByteMasks();

/// The bytes, 0 | 255, of each nibble's four pixels of one channel.
constexpr uint32_t bytesOf(unsigned nibble) {
  return ((nibble & 1) | (nibble & 2) << 7 | (nibble & 4) << 14 | (nibble & 8) << 21) * 255;
}

/// Sum of those of four bytes that the nibble chooses.
unsigned sumOf(const uint8_t* four, unsigned nibble) {
  uint32_t word;
  std::memcpy(&word, four, 4);
  word &= bytesOf(nibble);
  word = (word & 0x00ff00ffu) + (word >> 8 & 0x00ff00ffu);
  return (word + (word >> 16)) & 0xffffu;
}

using Four = float __attribute__((vector_size(16)));

Four everyNth(const uint8_t* bytes, int n) {
  return Four{float(bytes[0]), float(bytes[n]), float(bytes[2 * n]), float(bytes[3 * n])};
}

/// Of what lies between 0 and 1; what does not counts as the nearer of them.
Four rootsOf(Four squares) {
  Four roots;
  for (int i = 0; i < kSide; ++i) roots[i] = std::sqrt(std::min(1.0f, std::max(0.0f, squares[i])));
  return roots;
}

/// Sums the chosen pixels of a block's rows byte by byte: bytes are widened to 16 bits, every other
/// one to a word. The words are little endian, as the masks of bits are.
class ByteSums {
 public:
  /// \param bytes 3 kSide
  void add(const uint8_t* bytes, unsigned nibble) {
    uint64_t words[2] = {};
    std::memcpy(words, bytes, 3 * kSide);
    for (int i = 0; i < 2; ++i) {
      const uint64_t chosen = words[i] & kByteMasks[nibble][i];
      sums_[2 * i] += chosen & kEven;
      sums_[2 * i + 1] += chosen >> 8 & kEven;
    }
  }
  void addTo(uint16_t* color) const {
    for (int i = 0; i < 3 * kSide; ++i)
      color[i % 3] =
          uint16_t(color[i % 3] + (sums_[i / 8 * 2 + i % 2] >> (16 * (i % 8 / 2)) & 0xffff));
  }

 private:
  static constexpr uint64_t kEven = 0x00ff00ff00ff00ffu;
  uint64_t sums_[4] = {};
};

}  // namespace

void RimRefiner::refine(const cv::Mat& image, const Background& background, double gain,
                        const PixelClasses& classes, BitMask* mask) {
  const Scene scene{image, background, float(gain), classes};
  columns_ = (image.cols + kSide - 1) / kSide;
  rows_ = (image.rows + kSide - 1) / kSide;
  stride_ = columns_ * kSide;
  share_.resize(size_t(stride_) * image.rows);
  core_ = eroded(*mask, 1);
  outer_ = dilated(*mask, kReach);
  band_ = eroded(*mask, kReach);
  for (size_t i = 0; i < band_.words().size(); ++i)
    band_.words()[i] = outer_.words()[i] & ~band_.words()[i];
  findBlocks();
  for (const Block& block : blocks_) {
    sumBlock(scene, block.column, block.row);
    presetBlock(*mask, block.column, block.row);
  }
  for (const Block& block : blocks_)
    if (kind_[size_t(block.row) * columns_ + block.column] == kOnRim)
      estimateBlock(scene, around(block.column, block.row), block.column, block.row);
  smooth(mask);
}

void RimRefiner::findBlocks() {
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
        if (kind_[size_t(row) * columns_ + column] == kOnRim) continue;
        for (int v = row - 1; v <= row + 1; ++v)
          for (int u = column - 1; u <= column + 1; ++u) mark(u, v, kNearRim);
        mark(column, row, kOnRim);
      }
  sums_.resize(kind_.size());
}

void RimRefiner::presetBlock(const BitMask& mask, int column, int row) {
  for (int y = row * kSide; y < std::min((row + 1) * kSide, mask.rows()); ++y) {
    const uint64_t bits = nibble(mask, column * kSide, y);
    unpackBits(&bits, kSide, &share_[size_t(y) * stride_ + column * kSide]);
  }
}

void RimRefiner::sumBlock(const Scene& scene, int column, int row) {
  Sums& sums = sums_[size_t(row) * columns_ + column];
  sums = Sums();
  const int channels = scene.image.channels(), x0 = column * kSide;
  const bool is_whole = scene.image.cols - x0 >= kSide;
  const unsigned valid = is_whole ? 15u : (1u << (scene.image.cols - x0)) - 1;
  ByteSums bytes;
  unsigned insiders = 0, outsiders = 0, light = 0;
  for (int y = row * kSide; y < std::min((row + 1) * kSide, scene.image.rows); ++y) {
    const unsigned inside = nibble(core_, x0, y);
    const uint8_t* row = scene.image.ptr(y);
    if (channels == 3 && is_whole)
      bytes.add(row + size_t(3) * x0, inside);
    else
      forEachBit(inside, x0, [&](int x) {
        for (int c = 0; c < channels; ++c) sums.color[c] += row[x * channels + c];
      });
    insiders += countOf(inside);
    const unsigned outside = ~nibble(outer_, x0, y) & valid;
    const unsigned shade = outside & nibble(scene.classes.shade, x0, y);
    outsiders += countOf(outside);
    light += 255 * countOf(outside & ~shade);
    light += sumOf(&scene.classes.ratio[size_t(y) * scene.background.stride() + x0], shade);
  }
  bytes.addTo(sums.color);
  sums.inside = uint16_t(insiders);
  sums.outside = uint16_t(outsiders);
  sums.light = uint16_t(light);
}

RimRefiner::Sums RimRefiner::around(int column, int row) const {
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

void RimRefiner::estimateBlock(const Scene& scene, const Sums& around, int column, int row) {
  if (around.inside == 0) return;
  const int channels = scene.image.channels(), x0 = column * kSide;
  const float light =
      around.outside > 0 ? float(around.light) / (255 * float(around.outside)) : 1.0f;
  const float scale = scene.gain * light, noise = float(scene.background.noise());
  float person[3];
  for (int c = 0; c < 3; ++c) person[c] = float(around.color[c]) / around.inside;
  const int width = std::min(kSide, scene.image.cols - x0);
  for (int y = row * kSide; y < std::min((row + 1) * kSide, scene.image.rows); ++y) {
    const unsigned band = nibble(band_, x0, y);
    if (!band) continue;
    uint8_t pixels[3 * kSide] = {};
    std::memcpy(pixels, scene.image.ptr(y) + size_t(x0) * channels, size_t(width) * channels);
    const ModeRow mode = scene.background.coarse(0, y);
    Four apart = {}, contrast = {};
    for (int c = 0; c < channels; ++c) {
      const Four usual = everyNth(mode.mean[c] + x0, 1) * scale;
      const Four off = everyNth(pixels + c, channels) - usual, whole = person[c] - usual;
      apart += off * off;
      contrast += whole * whole;
    }
    const Four share = rootsOf((apart - noise * noise * float(channels)) / contrast);
    uint8_t* out = &share_[size_t(y) * stride_ + x0];
    for (int i = 0; i < kSide; ++i) {
      const bool is_told = (band >> i & 1) & (contrast[i] >= kLeastContrast * float(channels));
      out[i] = is_told ? uint8_t(int(255 * share[i])) : out[i];
    }
  }
}

/// The outline is smooth: a pixel is the person's if more than half of its surroundings are.
void RimRefiner::smooth(BitMask* mask) const {
  constexpr int kHalf = 255 * 25 / 2;
  const auto line = [](const uint8_t* at) { return at[-1] + 3 * at[0] + at[1]; };
  for (int y = 1; y + 1 < mask->rows(); ++y)
    for (int i = 0; i < mask->rowWords(); ++i)
      forEachBit(band_.row(y)[i], 64 * i, [&](int x) {
        if (x == 0 || x + 1 == mask->cols()) return;
        const uint8_t* at = &share_[size_t(y) * stride_ + x];
        const bool is_person = line(at - stride_) + 3 * line(at) + line(at + stride_) > kHalf;
        if (is_person != mask->at(x, y)) mask->flip(x, y);
      });
}

}  // namespace markerless_mocap
