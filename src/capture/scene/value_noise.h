#pragma once

#include <cstdint>

namespace markerless_mocap {

/// Integer part, rounded down; std::floor is a function call on plain x86-64.
inline int floorOf(float value) {
  const int whole = int(value);
  return whole - int(value < float(whole));
}

/// Value noise, -1 to 1, with a period of one unit.
float smoothNoise(uint64_t seed, float x, float y);

/// Sum of noise of several sizes; the largest is `size` metres, each further one half of that.
float fractalNoise(uint64_t seed, float x, float y, float size, int octaves);

}  // namespace markerless_mocap
