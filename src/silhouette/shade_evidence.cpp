#include "silhouette/shade_evidence.h"

#include <algorithm>

#include "silhouette/bit_morphology.h"

namespace markerless_mocap {
namespace {

/// Standard deviation of the brightness ratio above which a shade is taken for clothes: where the
/// person encloses it, and elsewhere. Noise alone gives 0.015, a shadow's soft rim up to 0.05.
constexpr float kUnevenEnclosed = 0.045f, kUnevenOpen = 0.08f;
/// How far the person may be from an enclosed pixel, in image widths.
constexpr double kReach = 0.1;

/// One bit for each four: whether any of them is set.
uint64_t quartered(uint64_t word) {
  word |= word >> 1;
  word = (word | word >> 2) & 0x1111111111111111u;
  word = (word | word >> 3) & 0x0303030303030303u;
  word = (word | word >> 6) & 0x000f000f000f000fu;
  word = (word | word >> 12) & 0x000000ff000000ffu;
  return (word | word >> 24) & 0xffffu;
}

/// Four bits for each of the lowest 16.
uint64_t quadrupled(uint64_t word) {
  word = (word & 0xffffu);
  word = (word | word << 24) & 0x000000ff000000ffu;
  word = (word | word << 12) & 0x000f000f000f000fu;
  word = (word | word << 6) & 0x0303030303030303u;
  word = (word | word << 3) & 0x1111111111111111u;
  return word * 15;
}

cv::Size blocksOf(const cv::Size& size) {
  const int side = ShadeBlocks::kSide;
  return {(size.width + side - 1) / side, (size.height + side - 1) / side};
}

BitMask blocksWithAny(const BitMask& mask) {
  BitMask blocks(blocksOf({mask.cols(), mask.rows()}));
  for (int y = 0; y < mask.rows(); ++y)
    for (int i = 0; i < mask.rowWords(); ++i)
      blocks.row(y / ShadeBlocks::kSide)[i / 4] |= quartered(mask.row(y)[i]) << (16 * (i % 4));
  return blocks;
}

/// Moves all bits by one block and keeps those that leave a word for the next.
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

/// Every bit smeared by up to `reach` blocks to one side.
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

}  // namespace

void ShadeBlocks::resize(const cv::Size& size) {
  const cv::Size blocks = blocksOf(size);
  cols_ = blocks.width;
  rows_ = blocks.height;
  sums_.assign(size_t(cols_) * rows_, {});
}

float ShadeBlocks::variance(int column, int row) const {
  float count = 0, sum = 0, squares = 0;
  for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y)
    for (int x = std::max(0, column - 1); x <= std::min(cols_ - 1, column + 1); ++x) {
      const Sums& sums = sums_[size_t(y) * cols_ + x];
      count += sums.count;
      sum += sums.sum;
      squares += sums.squares;
    }
  if (count == 0) return 0;
  const float mean = sum / count;
  return (squares / count - mean * mean) / (255 * 255);
}

BitMask enclosedBlocks(const BitMask& mask, int reach) {
  const BitMask blocks = blocksWithAny(mask);
  const BitMask left = smearedSideways(blocks, reach, true);
  const BitMask right = smearedSideways(blocks, reach, false);
  const BitMask above = smearedVertically(blocks, reach, true);
  BitMask enclosed = smearedVertically(blocks, reach, false);
  for (size_t i = 0; i < enclosed.words().size(); ++i)
    enclosed.words()[i] &= left.words()[i] | right.words()[i] | above.words()[i];
  return enclosed;
}

void restoreClothes(const BitMask& shade, const ShadeBlocks& blocks, BitMask* foreground) {
  // Without specks, which would enclose shadows.
  const BitMask solid = eroded(*foreground, 1);
  const int reach = int(kReach * shade.cols()) / ShadeBlocks::kSide;
  const BitMask enclosed = enclosedBlocks(solid, reach);
  BitMask clothes(cv::Size(blocks.cols(), blocks.rows()));
  for (int row = 0; row < blocks.rows(); ++row)
    for (int column = 0; column < blocks.cols(); ++column) {
      if (blocks.isEmpty(column, row)) continue;
      const float most = enclosed.at(column, row) ? kUnevenEnclosed : kUnevenOpen;
      if (blocks.variance(column, row) > most * most) clothes.set(column, row);
    }
  for (int y = 0; y < shade.rows(); ++y)
    for (int i = 0; i < shade.rowWords(); ++i)
      foreground->row(y)[i] |=
          shade.row(y)[i] &
          quadrupled(clothes.row(y / ShadeBlocks::kSide)[i / 4] >> (16 * (i % 4)));
}

}  // namespace markerless_mocap
