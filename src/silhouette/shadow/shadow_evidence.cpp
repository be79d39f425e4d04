#include "silhouette/shadow/shadow_evidence.h"

#include <algorithm>

#include "silhouette/bits/bit_morphology.h"

namespace markerless_mocap {
namespace {

/// A candidate shadow whose brightness ratio has a larger standard deviation is taken for clothes.
/// There is one limit for pixels that the person encloses and one for others. Grey images have
/// limits of their own, as texture is then the only evidence.
struct Unevenness {
  float enclosed, open;
};
constexpr Unevenness kUneven{0.09f, 0.1f}, kUnevenGrey{0.04f, 0.06f};
/// Factor on the permitted difference in colour for candidates that the person encloses.
constexpr float kEnclosedFraction = 0.55f;
/// Squared distance of a mean colour that noise may cause, in variances of the mean.
constexpr float kMeanVariances = 3;
/// Maximum distance of the person from an enclosed pixel, in image widths.
constexpr double kReach = 0.1;
/// A brightness ratio of 1 in ShadowColumns.
constexpr float kFullRatio = 127;

/// One bit for each four bits, set if any of them is set.
uint64_t quartered(uint64_t word) {
  word |= word >> 1;
  word = (word | word >> 2) & 0x1111111111111111u;
  word = (word | word >> 3) & 0x0303030303030303u;
  word = (word | word >> 6) & 0x000f000f000f000fu;
  word = (word | word >> 12) & 0x000000ff000000ffu;
  return (word | word >> 24) & 0xffffu;
}

/// Four equal bits for each of the lowest 16 bits.
uint64_t quadrupled(uint64_t word) {
  word = (word & 0xffffu);
  word = (word | word << 24) & 0x000000ff000000ffu;
  word = (word | word << 12) & 0x000f000f000f000fu;
  word = (word | word << 6) & 0x0303030303030303u;
  word = (word | word << 3) & 0x1111111111111111u;
  return word * 15;
}

cv::Size blocksOf(const cv::Size& size) {
  const int side = ShadowBlocks::kSide;
  return {(size.width + side - 1) / side, (size.height + side - 1) / side};
}

BitMask blocksWithAny(const BitMask& mask) {
  BitMask blocks(blocksOf({mask.cols(), mask.rows()}));
  for (int y = 0; y < mask.rows(); ++y)
    for (int i = 0; i < mask.rowWords(); ++i)
      if (const uint64_t word = mask.row(y)[i])
        blocks.row(y / ShadowBlocks::kSide)[i / 4] |= quartered(word) << (16 * (i % 4));
  return blocks;
}

/// Shifts all bits of a row by `step` blocks; bits shifted out of a word are carried to the next.
void orShiftedRow(const BitMask& from, int y, int step, bool right, BitMask* to) {
  const int words = from.rowWords(), far = step >> 6, near = step & 63;
  for (int i = 0; i < words; ++i) {
    const int source = right ? i - far : i + far, next = right ? source - 1 : source + 1;
    uint64_t word = 0;
    if (source >= 0 && source < words)
      word = right ? from.row(y)[source] << near : from.row(y)[source] >> near;
    if (near > 0 && next >= 0 && next < words)
      word |= right ? from.row(y)[next] >> (64 - near) : from.row(y)[next] << (64 - near);
    to->row(y)[i] |= word;
  }
}

/// The mask extended by up to `reach` blocks to one side.
BitMask smearedSideways(BitMask mask, int reach, bool right) {
  for (int covered = 0; covered < reach;) {
    const int step = std::min(covered + 1, reach - covered);
    const BitMask from = mask;
    for (int y = 0; y < mask.rows(); ++y) orShiftedRow(from, y, step, right, &mask);
    covered += step;
  }
  return mask;
}

BitMask smearedVertically(BitMask mask, int reach, bool down) {
  for (int covered = 0; covered < reach;) {
    const int step = std::min(covered + 1, reach - covered);
    const BitMask from = mask;
    for (int y = 0; y < mask.rows(); ++y) {
      const int source = down ? y - step : y + step;
      if (source < 0 || source >= mask.rows()) continue;
      for (int i = 0; i < mask.rowWords(); ++i) mask.row(y)[i] |= from.row(source)[i];
    }
    covered += step;
  }
  return mask;
}

/// Evidence that candidate shadow pixels are clothes; above 1 they are taken for clothes.
float clothesEvidence(const ShadowBlocks::Sums& sums, const BlockShadowThresholds& limits,
                      bool enclosed) {
  float cross = 0, expected = 0, now = 0;
  for (int c = 0; c < 3; ++c) {
    const float lit = sums.expected[c] * limits.gain;
    cross += sums.now[c] * lit;
    expected += lit * lit;
    now += sums.now[c] * sums.now[c];
  }
  if (cross <= 0) return 0;  // black: no evidence
  const float ratio = cross / expected, noise = limits.squared_noise * sums.count;
  const float off = std::max(0.0f, now - ratio * cross - kMeanVariances * noise);
  const float chroma = limits.chroma * (enclosed ? kEnclosedFraction : 1);
  const float variance = sums.degrees_of_freedom > 0 ? sums.uneven / sums.degrees_of_freedom : 0;
  const float uneven = std::max(0.0f, variance - noise * sums.count / expected);
  const Unevenness& max = limits.is_grey ? kUnevenGrey : kUneven;
  const float max_uneven = enclosed ? max.enclosed : max.open;
  return off / (chroma * chroma * ratio * cross) + uneven / (max_uneven * max_uneven);
}

}  // namespace

void ShadowBlocks::resize(const cv::Size& size) {
  const cv::Size blocks = blocksOf(size);
  cols_ = blocks.width;
  rows_ = blocks.height;
  for (const size_t i : filled_) sums_[i] = {};  // most of them are empty already
  filled_.clear();
  sums_.resize(size_t(cols_) * rows_);
}

void ShadowBlocks::add(const ShadowColumns& columns, int word, int row) {
  const int first = word * ShadowColumns::kCols / kSide;
  const int last = std::min(first + ShadowColumns::kCols / kSide, cols_);
  for (int column = first; column < last; ++column) {
    const auto sum = [&](const uint16_t* values) {
      const uint16_t* four = values + ptrdiff_t(kSide) * (column - first);
      return float(four[0] + four[1] + four[2] + four[3]);
    };
    const float count = sum(columns.count);
    if (count == 0) continue;
    filled_.push_back(size_t(row) * cols_ + column);
    Sums& sums = sums_[filled_.back()];
    sums.count = count;
    for (int c = 0; c < 3; ++c) {
      sums.now[c] = sum(columns.now[c]);
      sums.expected[c] = sum(columns.expected[c]);
    }
    const float ratio = sum(columns.ratio);
    sums.uneven = (sum(columns.squares) - ratio * ratio / count) / (kFullRatio * kFullRatio);
    sums.degrees_of_freedom = count - 1;
  }
}

ShadowBlocks::Sums ShadowBlocks::around(int column, int row) const {
  Sums sum;
  for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y)
    for (int x = std::max(0, column - 1); x <= std::min(cols_ - 1, column + 1); ++x) {
      const Sums& one = at(x, y);
      sum.count += one.count;
      for (int c = 0; c < 3; ++c) {
        sum.now[c] += one.now[c];
        sum.expected[c] += one.expected[c];
      }
      sum.uneven += one.uneven;
      sum.degrees_of_freedom += one.degrees_of_freedom;
    }
  return sum;
}

BitMask enclosedBlocks(const BitMask& mask, int reach) {
  const BitMask blocks = blocksWithAny(mask);
  BitMask enclosed = smearedSideways(blocks, reach, true);
  enclosed |= smearedSideways(blocks, reach, false);
  enclosed |= smearedVertically(blocks, reach, true);
  enclosed &= smearedVertically(blocks, reach, false);
  return enclosed;
}

void restoreFalseShadows(const ShadowBlocks& blocks, const BlockShadowThresholds& limits,
                         BitMask* shadow, BitMask* foreground) {
  // Specks are removed, as they would enclose shadows.
  const BitMask solid = eroded(*foreground, 1);
  const int reach = int(kReach * shadow->cols()) / ShadowBlocks::kSide;
  const BitMask enclosed = enclosedBlocks(solid, reach);
  BitMask clothes(cv::Size(blocks.cols(), blocks.rows()));
  blocks.forEach([&](int column, int row) {
    if (clothesEvidence(blocks.around(column, row), limits, enclosed.at(column, row)) > 1)
      clothes.set(column, row);
  });
  for (int y = 0; y < shadow->rows(); ++y)
    for (int i = 0; i < shadow->rowWords(); ++i) {
      uint64_t& shadows = shadow->row(y)[i];
      if (!shadows) continue;
      const uint64_t restored =
          shadows & quadrupled(clothes.row(y / ShadowBlocks::kSide)[i / 4] >> (16 * (i % 4)));
      foreground->row(y)[i] |= restored;
      shadows &= ~restored;
    }
}

}  // namespace markerless_mocap
