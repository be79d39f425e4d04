#pragma once

#include <stddef.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// Spans [first, second) of words of an array. Both bounds are multiples of four, so that
/// vectorised loops have no remainder.
using WordSpans = std::vector<std::pair<size_t, size_t>>;

/// A set of words of an array, one bit per word.
class WordSet {
 public:
  WordSet() = default;
  explicit WordSet(size_t words) : bits_(words / 64 + 2, 0) {}

  void clear() { bits_.assign(bits_.size(), 0); }
  void remove(size_t word) { bits_[word / 64] &= ~(uint64_t(1) << (word % 64)); }
  void add(size_t word) { bits_[word / 64] |= uint64_t(1) << (word % 64); }
  /// Adds the words that lie `by` words before those of `other`.
  void addBefore(const WordSet& other, size_t by) {
    const size_t skip = by / 64, shift = by % 64;
    for (size_t i = 0; i + skip + 1 < other.bits_.size(); ++i) {
      bits_[i] |= other.bits_[i + skip] >> shift;
      if (shift != 0) bits_[i] |= other.bits_[i + skip + 1] << (64 - shift);
    }
  }
  /// Lists spans that cover the set; their bounds are multiples of four, and gaps of four words are
  /// bridged.
  void list(WordSpans* spans) const {
    spans->clear();
    for (size_t i = 0; i < bits_.size(); ++i) {
      uint64_t fours = bits_[i] | bits_[i] >> 1;
      fours = (fours | fours >> 2) & 0x1111111111111111u;
      for (; fours != 0; fours &= fours - 1) {
        const size_t begin = i * 64 + size_t(__builtin_ctzll(fours));
        if (!spans->empty() && begin <= spans->back().second + 4) {
          spans->back().second = begin + 4;
        } else {
          spans->emplace_back(begin, begin + 4);
        }
      }
    }
  }

 private:
  std::vector<uint64_t> bits_;
};

}  // namespace markerless_mocap
