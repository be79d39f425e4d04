#pragma once

#include <cstdint>

namespace markerless_mocap {

/// Counter-based random bits: the finaliser of SplitMix64 (Steele et al. 2014).
inline uint64_t hashBits(uint64_t counter) {
  uint64_t z = counter + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Uniform in 0 to 1.
inline double hashUniform(uint64_t counter) {
  return double(hashBits(counter) >> 11) * 0x1p-53;
}

}  // namespace markerless_mocap
