#include "hull/voting/mask_packing.h"

#include <algorithm>

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

uint64_t packTile(const uint8_t* pixels, size_t step, int width, int rows) {
  uint64_t word = 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < width; ++x) word |= uint64_t(pixels[y * step + x] != 0) << (8 * y + x);
  return word;
}

#ifdef MOCAP_X86
/// Two tiles; a bit is set if its pixel is 0.
void clearBitsOfTwo(const uint8_t* pixels, size_t step, uint64_t* first, uint64_t* second) {
  const __m128i zero = _mm_setzero_si128();
  *first = *second = 0;
  for (int y = 0; y < 8; y += 2) {
    const auto row = [&](int r) {
      return _mm_cmpeq_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels + r * step)),
                            zero);
    };
    const __m128i a = row(y), b = row(y + 1);
    *first |= uint64_t(uint32_t(_mm_movemask_epi8(_mm_unpacklo_epi64(a, b)))) << (8 * y);
    *second |= uint64_t(uint32_t(_mm_movemask_epi8(_mm_unpackhi_epi64(a, b)))) << (8 * y);
  }
}

void packPairs(const uint8_t* pixels, size_t step, int tiles, uint64_t* out, size_t stride) {
  for (int i = 0; i + 1 < tiles; i += 2) {
    uint64_t first, second;
    clearBitsOfTwo(pixels + i * 8, step, &first, &second);
    out[i * stride] = ~first;
    out[(i + 1) * stride] = ~second;
  }
}

/// Four rows of four tiles: one register of four rows for each tile.
MOCAP_AVX2 inline void loadFour(const uint8_t* pixels, size_t step, __m256i (&tile)[4]) {
  const __m256i zero = _mm256_setzero_si256();
  __m256i row[4];
  for (int y = 0; y < 4; ++y)
    row[y] = _mm256_cmpeq_epi8(
        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(pixels + y * step)), zero);
  const __m256i a = _mm256_unpacklo_epi64(row[0], row[1]);
  const __m256i b = _mm256_unpackhi_epi64(row[0], row[1]);
  const __m256i c = _mm256_unpacklo_epi64(row[2], row[3]);
  const __m256i d = _mm256_unpackhi_epi64(row[2], row[3]);
  tile[0] = _mm256_permute2x128_si256(a, c, 0x20);
  tile[1] = _mm256_permute2x128_si256(b, d, 0x20);
  tile[2] = _mm256_permute2x128_si256(a, c, 0x31);
  tile[3] = _mm256_permute2x128_si256(b, d, 0x31);
}

MOCAP_AVX2 void packFours(const uint8_t* pixels, size_t step, int tiles, uint64_t* out,
                          size_t stride) {
  for (int i = 0; i + 3 < tiles; i += 4) {
    __m256i upper[4], lower[4];
    loadFour(pixels + i * 8, step, upper);
    loadFour(pixels + i * 8 + 4 * step, step, lower);
    for (int t = 0; t < 4; ++t)
      out[(i + t) * stride] = ~(uint64_t(uint32_t(_mm256_movemask_epi8(upper[t]))) |
                                uint64_t(uint32_t(_mm256_movemask_epi8(lower[t]))) << 32);
  }
}
#endif

}  // namespace

void packTileRowPlainly(const uint8_t* pixels, size_t step, int width, int rows, uint64_t* out,
                        size_t stride) {
  for (int x = 0; x < width; x += 8)
    out[x / 8 * stride] = packTile(pixels + x, step, std::min(8, width - x), rows);
}

void packTileRow(const uint8_t* pixels, size_t step, int width, int rows, uint64_t* out,
                 size_t stride) {
  int done = 0;
#ifdef MOCAP_X86
  const int tiles = rows == 8 ? width / 8 : 0;
  if (kHasAvx2) {
    packFours(pixels, step, tiles, out, stride);
    done = tiles / 4 * 4;
  }
  packPairs(pixels + done * 8, step, tiles - done, out + done * stride, stride);
  done += (tiles - done) / 2 * 2;
#endif
  packTileRowPlainly(pixels + ptrdiff_t(done) * 8, step, width - done * 8, rows,
                     out + done * stride, stride);
}

MOCAP_WIDEST size_t sumTileColumn(const uint64_t* tiles, int rows, uint64_t beside, uint64_t below,
                                  const uint64_t* before, uint64_t* after) {
  size_t set = 0;
  uint64_t column = 0;
  after[0] = 0;
  for (int y = 0; y < rows; ++y) {
    const uint64_t word = tiles[y], outside = beside | (y == rows - 1 ? below : 0);
    column += uint64_t(word != 0) | uint64_t((word | outside) == ~uint64_t(0)) << 32;
    after[y + 1] = before[y + 1] + column;
    set += size_t(__builtin_popcountll(word));
  }
  return set;
}

}  // namespace markerless_mocap
