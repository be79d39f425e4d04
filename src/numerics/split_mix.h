#pragma once

#include <cstdint>

namespace markerless_mocap {

/// Random bits as a function of a counter: SplitMix64 (Steele, Lea, Flood 2014).
inline uint64_t splitMix64(uint64_t counter) {
  uint64_t z = counter + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Uniform in [0, 1), as a function of a counter.
inline double splitMixUniform(uint64_t counter) {
  return double(splitMix64(counter) >> 11) * 0x1p-53;
}

}  // namespace markerless_mocap
