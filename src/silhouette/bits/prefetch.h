#pragma once

#include <cstddef>
#include <cstdint>

namespace markerless_mocap {

constexpr int kCacheLine = 64;

/// Asks memory for what is needed soon, as it takes longer than the work before. Inline, as calls
/// of a function without effect are left out.
__attribute__((always_inline)) inline void prefetch(const void* from, size_t bytes) {
  const auto* line = static_cast<const uint8_t*>(from);
  for (size_t i = 0; i < bytes; i += kCacheLine) __builtin_prefetch(line + i);
}

}  // namespace markerless_mocap
