#include "fleischmann/fitness/bit_image.h"

#include <algorithm>
#include <cstring>

namespace markerless_mocap {
namespace {

/// Bits of eight bytes that are not zero, the first byte in the lowest bit.
uint32_t setBits(const uint8_t* bytes) {
  constexpr uint64_t kLow7 = 0x7f7f7f7f7f7f7f7fu;
  uint64_t eight;
  std::memcpy(&eight, bytes, sizeof(eight));
  if (eight == 0) return 0;
  const uint64_t tops = ((eight & kLow7) + kLow7) | eight;  // top bit of each non-zero byte
  // The multiplication moves bit 8 i to 56 + i.
  return uint32_t(((tops >> 7 & 0x0101010101010101u) * 0x0102040810204080u) >> 56);
}

}  // namespace

BitImage::BitImage(int width, int height)
    : width_(width), height_(height), words_(size_t(columns()) * size_t(height), 0u) {}

BitImage::BitImage(const cv::Mat& mask) : BitImage(mask.cols, mask.rows) {
  for (int y = 0; y < height_; ++y) {
    for (int c = 0; c < columns(); ++c) {
      const uint8_t* from = mask.ptr<uint8_t>(y, 32 * c);
      const int pixels = std::min(32, width_ - 32 * c);
      uint32_t word = 0;
      int i = 0;
      for (; i + 8 <= pixels; i += 8) word |= setBits(from + i) << i;
      for (; i < pixels; ++i) word |= uint32_t(from[i] != 0) << i;
      column(c)[y] = word;
    }
  }
}

int64_t BitImage::count() const {
  int64_t sum = 0;
  for (const uint32_t word : words_) sum += __builtin_popcount(word);
  return sum;
}

cv::Mat BitImage::mask() const {
  cv::Mat out(height_, width_, CV_8UC1);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) out.at<uint8_t>(y, x) = at(x, y) ? 255 : 0;
  return out;
}

}  // namespace markerless_mocap
