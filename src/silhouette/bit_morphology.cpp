#include "silhouette/bit_morphology.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

/// out |= in moved right and left by `s` pixels. `out` is not `in`.
void orMoved(const uint64_t* in, int words, int s, uint64_t* out) {
  const int far = s >> 6, near = s & 63;
  for (int i = 0; i + far < words; ++i) {
    out[i + far] |= in[i] << near;
    out[i] |= in[i + far] >> near;
  }
  if (near == 0) return;
  for (int i = 0; i + far + 1 < words; ++i) {
    out[i + far + 1] |= in[i] >> (64 - near);
    out[i] |= in[i + far + 1] << (64 - near);
  }
}

/// Dilates a row by `width` pixels to both sides; `row` and `scratch` hold `words` words.
void widenRow(int width, int words, uint64_t* row, uint64_t* scratch) {
  // Moving by one more than the reach leaves no gap, also where the image's border cut half off.
  for (int reach = 0; reach < width;) {
    const int step = std::min(reach + 1, width - reach);
    std::copy(row, row + words, scratch);
    orMoved(scratch, words, step, row);
    reach += step;
  }
}

/// Half width of the disk in each of its rows -radius..radius.
std::vector<int> diskWidths(int radius) {
  std::vector<int> widths(2 * radius + 1);
  for (int dy = -radius; dy <= radius; ++dy)
    widths[dy + radius] =
        radius > 0 ? int(std::lrint(std::sqrt(double(radius * radius - dy * dy)))) : 0;
  return widths;
}

BitMask dilatedRows(const BitMask& mask, const std::vector<int>& widths) {
  const int words = mask.rowWords(), radius = int(widths.size()) / 2;
  BitMask out(cv::Size(mask.cols(), mask.rows()));
  std::vector<uint64_t> wide(words), scratch(words);
  for (int y = 0; y < mask.rows(); ++y) {
    if (mask.isEmptyRow(y)) continue;
    std::copy(mask.row(y), mask.row(y) + words, wide.begin());
    // From the tips inward the disk only becomes wider.
    for (int dy = radius, reach = 0; dy >= 0; --dy) {
      const int width = widths[dy + radius];
      widenRow(width - reach, words, wide.data(), scratch.data());
      reach = width;
      for (const int to : {y - dy, y + dy})
        if (to >= 0 && to < mask.rows())
          for (int i = 0; i < words; ++i) out.row(to)[i] |= wide[i];
    }
  }
  for (int y = 0; y < out.rows(); ++y) out.row(y)[words - 1] &= out.tailBits();
  return out;
}

BitMask inverted(const BitMask& mask) {
  BitMask out = mask;
  for (uint64_t& word : out.words()) word = ~word;
  for (int y = 0; y < out.rows(); ++y) out.row(y)[out.rowWords() - 1] &= out.tailBits();
  return out;
}

}  // namespace

BitMask dilated(const BitMask& mask, int radius) {
  return radius == 0 ? mask : dilatedRows(mask, diskWidths(radius));
}

BitMask eroded(const BitMask& mask, int radius) {
  return radius == 0 ? mask : inverted(dilated(inverted(mask), radius));
}

BitMask dilatedByBox(const BitMask& mask, int dx, int dy) {
  return dilatedRows(mask, std::vector<int>(2 * dy + 1, dx));
}

}  // namespace markerless_mocap
