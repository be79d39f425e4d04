#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// A binary image: 64 pixels of a row per word, the leftmost in the lowest bit. Bits right of the
/// last column are 0.
class BitMask {
 public:
  BitMask() = default;
  explicit BitMask(const cv::Size& size) { resize(size); }
  /// \param mask CV_8UC1, non-zero = set
  static BitMask fromMat(const cv::Mat& mask);
  /// CV_8UC1, 0 | 255
  cv::Mat toMat() const;

  /// Sets the size and clears all bits.
  void resize(const cv::Size& size);
  void clear() { words_.assign(words_.size(), 0); }
  int cols() const { return cols_; }
  int rows() const { return rows_; }
  int rowWords() const { return row_words_; }
  uint64_t* row(int y) { return words_.data() + size_t(y) * row_words_; }
  const uint64_t* row(int y) const { return words_.data() + size_t(y) * row_words_; }
  const std::vector<uint64_t>& words() const { return words_; }
  std::vector<uint64_t>& words() { return words_; }
  bool at(int x, int y) const { return row(y)[x >> 6] >> (x & 63) & 1; }
  void set(int x, int y) { row(y)[x >> 6] |= uint64_t(1) << (x & 63); }
  void flip(int x, int y) { row(y)[x >> 6] ^= uint64_t(1) << (x & 63); }
  /// With a mask of the same size, or an empty one, which holds nothing.
  void operator|=(const BitMask& other);
  void operator&=(const BitMask& other);
  /// Clears the pixels that the other one holds.
  void remove(const BitMask& other);
  /// Sets the pixels first..last of a row, both inclusive, to `value`.
  void fill(int y, int first, int last, bool value);
  /// The valid bits of a row's last word.
  uint64_t tailBits() const;
  size_t count() const;

 private:
  int cols_ = 0, rows_ = 0, row_words_ = 0;
  std::vector<uint64_t> words_;
};

/// Packs 64 flags (0 or 1) into a word.
uint64_t packFlags(const uint8_t* flags);

/// Unpacks n bits to bytes, 0 | 255.
void unpackBits(const uint64_t* bits, int n, uint8_t* bytes);

/// Calls `visit(x)` for each set bit of a word whose lowest bit is pixel `x0`.
template <class VisitT>
void forEachBit(uint64_t word, int x0, const VisitT& visit) {
  for (; word; word &= word - 1) visit(x0 + __builtin_ctzll(word));
}

}  // namespace markerless_mocap
