#pragma once

#include <stddef.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace markerless_mocap {

/// Layout of a box of voxels as rows of bits along x. All sides have a margin of one empty voxel,
/// so voxel (i, j, k) of the box is bit i + 1 of row (j + 1, k + 1), and a shift across the end of
/// a row shifts in zeros. Before and after the rows there are empty words, so that the neighbours
/// of all voxels of the margin can be read.
struct BitBox {
  int nx = 0, ny = 0, nz = 0;  ///< voxels without margin
  size_t row = 0;              ///< words from one row to the next along y
  size_t plane = 0;            ///< words from one row to the next along z
  size_t guard = 0;            ///< empty words before the first row and after the last
  size_t words = 0;            ///< number of words of the array

  BitBox() = default;
  BitBox(int nx, int ny, int nz);

  /// Index of the first word of a row; y in [0, ny + 1], z in [0, nz + 1].
  size_t wordOf(int y, int z) const { return guard + size_t(z) * plane + size_t(y) * row; }
  /// Index of a voxel's bit in the array; x, y, z from 0, without margin.
  size_t bitOf(int x, int y, int z) const { return wordOf(y + 1, z + 1) * 64 + size_t(x) + 1; }
};

using BitWords = std::vector<uint64_t>;

inline bool testBit(const BitWords& words, size_t bit) {
  return words[bit / 64] >> (bit % 64) & 1;
}
inline void setBit(BitWords* words, size_t bit) {
  (*words)[bit / 64] |= uint64_t(1) << (bit % 64);
}
inline void clearBit(BitWords* words, size_t bit) {
  (*words)[bit / 64] &= ~(uint64_t(1) << (bit % 64));
}

/// The 3 x 3 x 3 neighbourhood of a voxel with the voxel itself: bit 9 (dz + 1) + 3 (dy + 1) + (dx
/// + 1).
inline uint32_t neighborhood(const BitBox& box, const uint64_t* words, size_t bit) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "rows are read bytewise");
  const char* bytes = reinterpret_cast<const char*>(words) + (bit - 1) / 8;
  const int shift = int((bit - 1) % 8);
  const auto row = ptrdiff_t(box.row * 8), plane = ptrdiff_t(box.plane * 8);
  uint32_t result = 0;
  for (int k = -1; k <= 1; ++k) {
    for (int j = -1; j <= 1; ++j) {
      uint16_t three;
      std::memcpy(&three, bytes + k * plane + j * row, sizeof(three));
      result |= (uint32_t(three) >> shift & 7u) << (9 * k + 3 * j + 12);
    }
  }
  return result;
}

/// Calls visit(bit) for each voxel in ascending order.
template <class Visit>
void forEachBit(const BitBox& box, const BitWords& words, Visit visit) {
  for (size_t i = box.guard; i < words.size() - box.guard; ++i)
    for (uint64_t left = words[i]; left != 0; left &= left - 1)
      visit(i * 64 + size_t(__builtin_ctzll(left)));
}

}  // namespace markerless_mocap
