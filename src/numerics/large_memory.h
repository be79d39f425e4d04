#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace markerless_mocap {

/// Memory of megabytes that is soon filled, not set to anything, in large pages where the system
/// has them: getting small ones can cost more than filling them. Throws std::bad_alloc.
inline std::shared_ptr<uint8_t> largeMemory(size_t bytes) {
  constexpr size_t kLargePage = size_t(2) << 20;  // bytes
  const size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
  void* memory = std::aligned_alloc(kLargePage, whole);
  if (!memory) throw std::bad_alloc();
#ifdef __linux__
  static_cast<void>(madvise(memory, whole, MADV_HUGEPAGE));  // without them it is only slower
#endif
  return {static_cast<uint8_t*>(memory), std::free};
}

}  // namespace markerless_mocap
