#include "hull/leaf_test.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace markerless_mocap {
namespace {

#ifdef __x86_64__
/// Left and right half of the window, a byte per row: eight pixels from column x on.
struct WindowHalves {
  __m128i left, right;
};

__attribute__((target("avx2"))) inline WindowHalves loadWindow(const BitMask& mask, int x, int y) {
  const uint8_t* column = mask.pixels(x >> 3, y);
  const auto load = [&](int i) __attribute__((target("avx2"))) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(column + i * mask.columnBytes()));
  };
  const __m128i a = load(0), b = load(1), c = load(2);
  const __m128i right_by = _mm_cvtsi32_si128(x & 7), left_by = _mm_cvtsi32_si128(8 - (x & 7));
  // There are no shifts of bytes: shift 16 bits and drop what came from the neighbour.
  const __m128i low = _mm_set1_epi8(char(0xff >> (x & 7)));
  const auto joined = [&](__m128i first, __m128i second) __attribute__((target("avx2"))) {
    return _mm_or_si128(_mm_and_si128(_mm_srl_epi16(first, right_by), low),
                        _mm_andnot_si128(low, _mm_sll_epi16(second, left_by)));
  };
  return {joined(a, b), joined(b, c)};
}

__attribute__((target("avx2"))) uint64_t setInWindowAvx2(const BitMask& mask, int x, int y,
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
    // Bit 3 of the column says which half; as the highest bit it is what blendv asks for.
    const __m256i pixels =
        _mm256_blendv_epi8(_mm256_shuffle_epi8(left, row), _mm256_shuffle_epi8(right, row),
                           _mm256_slli_epi16(column, 4));
    const __m256i bit = _mm256_shuffle_epi8(bits, column);
    const __m256i set = _mm256_cmpeq_epi8(_mm256_and_si256(pixels, bit), bit);
    result |= uint64_t(uint32_t(_mm256_movemask_epi8(set))) << (half * 32);
  }
  return result;
}
#endif

using WindowTest = uint64_t (*)(const BitMask&, int, int, const uint8_t*);

WindowTest fastestTest() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return setInWindowAvx2;
#endif
  return setInWindowPlainly;
}

}  // namespace

uint64_t setInWindowPlainly(const BitMask& mask, int x, int y, const uint8_t* codes) {
  uint64_t result = 0;
  for (int v = 0; v < 64; ++v)
    result |= uint64_t(mask.at(x + (codes[v] & 15), y + (codes[v] >> 4))) << v;
  return result;
}

uint64_t setInWindow(const BitMask& mask, int x, int y, const uint8_t* codes) {
  static const WindowTest test = fastestTest();
  return test(mask, x, y, codes);
}

uint64_t setInLeaf(const CarvingPlan& plan, const BitMask& mask, size_t leaf, size_t camera) {
  const uint8_t* codes = plan.codes(leaf, camera);
  uint64_t set = 0;
  const PixelWindow* end = plan.windowsEnd(leaf, camera);
  for (const PixelWindow* w = plan.windowsBegin(leaf, camera); w != end; ++w)
    set |= w->voxels & setInWindow(mask, w->x, w->y, codes);
  return set;
}

}  // namespace markerless_mocap
