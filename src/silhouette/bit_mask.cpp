#include "silhouette/bit_mask.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace markerless_mocap {
namespace {

/// The eight bytes, 0 | 255, of each value of eight bits.
std::array<uint64_t, 256> makeByteTable() {
  std::array<uint64_t, 256> table{};
  for (int bits = 0; bits < 256; ++bits)
    for (int i = 0; i < 8; ++i)
      if (bits >> i & 1) table[bits] |= uint64_t(255) << (8 * i);
  return table;
}

uint64_t bitsUpTo(int last) {
  return last == 63 ? ~uint64_t(0) : (uint64_t(1) << (last + 1)) - 1;
}

}  // namespace

uint64_t packFlags(const uint8_t* flags) {
  uint64_t word = 0;
  for (int i = 0; i < 8; ++i) {
    uint64_t eight;
    std::memcpy(&eight, flags + 8 * i, 8);
    // The product brings flag k, at bit 8k, to bit 56 + k.
    word |= (eight * 0x0102040810204080u >> 56) << (8 * i);
  }
  return word;
}

BitMask BitMask::fromMat(const cv::Mat& mask) {
  BitMask bits(mask.size());
  std::vector<uint8_t> flags(size_t(bits.row_words_) * 64, 0);
  for (int y = 0; y < mask.rows; ++y) {
    const uint8_t* in = mask.ptr(y);
    for (int x = 0; x < mask.cols; ++x) flags[x] = in[x] != 0;
    for (int i = 0; i < bits.row_words_; ++i) bits.row(y)[i] = packFlags(&flags[size_t(64) * i]);
  }
  return bits;
}

cv::Mat BitMask::toMat() const {
  static const std::array<uint64_t, 256> kBytes = makeByteTable();
  cv::Mat mask(rows_, cols_, CV_8UC1);
  for (int y = 0; y < rows_; ++y) {
    uint8_t* out = mask.ptr(y);
    for (int x = 0; x < cols_; x += 8)
      std::memcpy(out + x, &kBytes[row(y)[x >> 6] >> (x & 63) & 255], std::min(8, cols_ - x));
  }
  return mask;
}

void BitMask::resize(const cv::Size& size) {
  cols_ = size.width;
  rows_ = size.height;
  row_words_ = (cols_ + 63) / 64;
  words_.assign(size_t(rows_) * row_words_, 0);
}

void BitMask::fill(int y, int first, int last, bool value) {
  for (int i = first >> 6; i <= last >> 6; ++i) {
    uint64_t bits = bitsUpTo(i == last >> 6 ? last & 63 : 63);
    if (i == first >> 6) bits &= ~uint64_t(0) << (first & 63);
    row(y)[i] = value ? row(y)[i] | bits : row(y)[i] & ~bits;
  }
}

uint64_t BitMask::tailBits() const {
  return bitsUpTo((cols_ - 1) & 63);
}

bool BitMask::isEmptyRow(int y) const {
  return std::all_of(row(y), row(y) + row_words_, [](uint64_t word) { return word == 0; });
}

size_t BitMask::count() const {
  size_t set = 0;
  for (const uint64_t word : words_) set += __builtin_popcountll(word);
  return set;
}

}  // namespace markerless_mocap
