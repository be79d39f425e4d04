#include "silhouette/bits/bit_mask.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace markerless_mocap {
namespace {

/// The eight bytes, 0 | 255, for each value of eight bits.
constexpr std::array<uint64_t, 256> makeByteTable() {
  std::array<uint64_t, 256> table{};
  for (int bits = 0; bits < 256; ++bits)
    for (int i = 0; i < 8; ++i)
      if (bits >> i & 1) table[bits] |= uint64_t(255) << (8 * i);
  return table;
}

constexpr std::array<uint64_t, 256> kBytes = makeByteTable();

/// Population count without the processor's instruction, which not every processor has.
uint64_t countBits(uint64_t word) {
  word -= word >> 1 & 0x5555555555555555u;
  word = (word & 0x3333333333333333u) + (word >> 2 & 0x3333333333333333u);
  word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fu;
  return word * 0x0101010101010101u >> 56;
}

uint64_t bitsUpTo(int last) {
  return last == 63 ? ~uint64_t(0) : (uint64_t(1) << (last + 1)) - 1;
}

}  // namespace

uint64_t packFlags(const uint8_t* flags) {
  uint64_t word = 0;
  for (size_t i = 0; i < 8; ++i) {
    uint64_t eight;
    std::memcpy(&eight, flags + 8 * i, 8);
    // The product moves flag k from bit 8k to bit 56 + k.
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

void unpackBits(const uint64_t* bits, int n, uint8_t* bytes) {
  const auto eight = [&](int i) { return &kBytes[bits[i >> 6] >> (i & 63) & 255]; };
  int i = 0;
  for (; i + 64 <= n; i += 64) {
    if (bits[i >> 6] == 0)  // the most common case
      std::memset(bytes + i, 0, 64);
    else
      for (int k = 0; k < 64; k += 8) std::memcpy(bytes + i + k, eight(i + k), 8);
  }
  for (; i + 8 <= n; i += 8) std::memcpy(bytes + i, eight(i), 8);
  if (i < n) std::memcpy(bytes + i, eight(i), n - i);
}

cv::Mat BitMask::toMat() const {
  cv::Mat mask(rows_, cols_, CV_8UC1);
  const auto is_empty = [this](int y) {
    return std::all_of(row(y), row(y) + row_words_, [](uint64_t word) { return word == 0; });
  };
  for (int y = 0; y < rows_; ++y)
    if (is_empty(y))
      std::memset(mask.ptr(y), 0, cols_);
    else
      unpackBits(row(y), cols_, mask.ptr(y));
  return mask;
}

void BitMask::resize(const cv::Size& size) {
  cols_ = size.width;
  rows_ = size.height;
  row_words_ = (cols_ + 63) / 64;
  words_.assign(size_t(rows_) * row_words_, 0);
}

void BitMask::operator|=(const BitMask& other) {
  for (size_t i = 0; i < other.words_.size(); ++i) words_[i] |= other.words_[i];
}

void BitMask::operator&=(const BitMask& other) {
  if (other.words_.empty()) clear();
  for (size_t i = 0; i < other.words_.size(); ++i) words_[i] &= other.words_[i];
}

void BitMask::remove(const BitMask& other) {
  for (size_t i = 0; i < std::min(words_.size(), other.words_.size()); ++i)
    words_[i] &= ~other.words_[i];
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

size_t BitMask::count() const {
  size_t set = 0;
  for (const uint64_t word : words_) set += countBits(word);
  return set;
}

}  // namespace markerless_mocap
