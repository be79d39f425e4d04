#include "hull/voting/brick_mask_lookup.h"

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

#ifdef MOCAP_X86
/// Left and right half of the window, one byte per row: eight pixels from column x on.
struct WindowHalves {
  __m128i left, right;
};

MOCAP_AVX2 inline WindowHalves loadWindow(const TileMask& mask, int x, int y) {
  const uint8_t* column = mask.pixels(x >> 3, y);
  const auto load = [&](int i) MOCAP_AVX2 {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(column + i * mask.columnBytes()));
  };
  const __m128i a = load(0), b = load(1), c = load(2);
  const __m128i right_by = _mm_cvtsi32_si128(x & 7), left_by = _mm_cvtsi32_si128(8 - (x & 7));
  // There is no shift of bytes: shift 16 bits and clear the bits that came from the neighbour.
  const __m128i low = _mm_set1_epi8(char(0xff >> (x & 7)));
  const auto joined = [&](__m128i first, __m128i second) MOCAP_AVX2 {
    return _mm_or_si128(_mm_and_si128(_mm_srl_epi16(first, right_by), low),
                        _mm_andnot_si128(low, _mm_sll_epi16(second, left_by)));
  };
  return {joined(a, b), joined(b, c)};
}

MOCAP_AVX2 inline uint64_t setInWindowAvx2(const TileMask& mask, int x, int y,
                                           const uint8_t* codes) {
  const WindowHalves halves = loadWindow(mask, x, y);
  const __m256i left = _mm256_broadcastsi128_si256(halves.left);
  const __m256i right = _mm256_broadcastsi128_si256(halves.right);
  const __m256i bits = _mm256_set1_epi64x(int64_t(0x8040201008040201u));
  const __m256i nibble = _mm256_set1_epi8(15);
  uint64_t result = 0;
  for (int half = 0; half < 2; ++half) {
    const __m256i code = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(codes + half * 32));
    const __m256i column = _mm256_and_si256(code, nibble);
    const __m256i row = _mm256_and_si256(_mm256_srli_epi16(code, 4), nibble);
    // Bit 3 of the column selects the half; blendv takes it as the top bit.
    const __m256i pixels =
        _mm256_blendv_epi8(_mm256_shuffle_epi8(left, row), _mm256_shuffle_epi8(right, row),
                           _mm256_slli_epi16(column, 4));
    const __m256i bit = _mm256_shuffle_epi8(bits, column);
    const __m256i set = _mm256_cmpeq_epi8(_mm256_and_si256(pixels, bit), bit);
    result |= uint64_t(uint32_t(_mm256_movemask_epi8(set))) << (half * 32);
  }
  return result;
}

MOCAP_AVX2 uint64_t setInWindowsAvx2(const TileMask& mask, const PixelWindow* begin,
                                     const PixelWindow* end, const uint8_t* codes) {
  uint64_t set = 0;
  for (const PixelWindow* w = begin; w != end; ++w)
    set |= w->voxels & setInWindowAvx2(mask, w->x, w->y, codes);
  return set;
}
#endif

}  // namespace

uint64_t setInWindowsPlainly(const TileMask& mask, const PixelWindow* begin, const PixelWindow* end,
                             const uint8_t* codes) {
  uint64_t set = 0;
  for (const PixelWindow* w = begin; w != end; ++w)
    for (uint64_t left = w->voxels; left != 0; left &= left - 1) {
      const int v = __builtin_ctzll(left);
      set |= uint64_t(mask.at(w->x + (codes[v] & 15), w->y + (codes[v] >> 4))) << v;
    }
  return set;
}

uint64_t setInWindows(const TileMask& mask, const PixelWindow* begin, const PixelWindow* end,
                      const uint8_t* codes) {
#ifdef MOCAP_X86
  if (kHasAvx2) return setInWindowsAvx2(mask, begin, end, codes);
#endif
  return setInWindowsPlainly(mask, begin, end, codes);
}

uint64_t setInBrick(const ProjectionTable& table, const TileMask& mask, size_t brick,
                    size_t camera) {
  return setInWindows(mask, table.windowsBegin(brick, camera), table.windowsEnd(brick, camera),
                      table.codes(brick, camera));
}

}  // namespace markerless_mocap
