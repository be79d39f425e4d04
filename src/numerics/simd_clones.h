#pragma once

/// Macros for code that is specific to a processor. On other processors, and with
/// MOCAP_PLAIN_KERNELS, they are empty and only the plain form of each kernel is compiled.
/// cmake/rooms.cmake tests the plain forms on any machine.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(MOCAP_PLAIN_KERNELS)

#include <immintrin.h>

#define MOCAP_X86

/// Marks a function that is called only if kHasAvx2 is true.
#define MOCAP_AVX2 __attribute__((target("avx2")))
#define MOCAP_AVX2_INLINE __attribute__((target("avx2"), always_inline)) inline

namespace markerless_mocap {
inline const bool kHasAvx2 = __builtin_cpu_supports("avx2");
}

#ifdef __SANITIZE_THREAD__  // what chooses among the clones runs before the sanitizer is there
#define MOCAP_CLONES(...)
#else
#define MOCAP_CLONES(...) __attribute__((target_clones(__VA_ARGS__, "default")))
#endif
#define MOCAP_AT_O3 __attribute__((optimize("O3")))

#else

#define MOCAP_CLONES(...)
#define MOCAP_AT_O3

#endif

/// Mark a function that is compiled for any processor and again for processors with these
/// instructions; the loader selects the version that fits.
#define MOCAP_WIDEST MOCAP_CLONES("avx2")
#define MOCAP_FUSED MOCAP_CLONES("fma")
#define MOCAP_COUNTING MOCAP_CLONES("avx2", "popcnt")
#define MOCAP_VECTORISED MOCAP_WIDEST MOCAP_AT_O3
