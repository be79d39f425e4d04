#pragma once

/// Before a function: compiled once for any processor and once for AVX2; the loader takes the one
/// that fits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MOCAP_VECTORISED __attribute__((target_clones("avx2", "default"), optimize("O3")))
#else
#define MOCAP_VECTORISED
#endif
