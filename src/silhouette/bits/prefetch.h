#pragma once

#include <cstddef>
#include <cstdint>

namespace markerless_mocap {

constexpr int kCacheLine = 64;

/// Prefetches data that is needed soon. Inline, as the compiler drops calls of a function without
/// side effects.
__attribute__((always_inline)) inline void prefetch(const void* from, size_t bytes) {
  const auto* line = static_cast<const uint8_t*>(from);
  for (size_t i = 0; i < bytes; i += kCacheLine) __builtin_prefetch(line + i);
}

}  // namespace markerless_mocap
