#pragma once

#include <malloc.h>

namespace markerless_mocap {

/// Tells the allocator to keep what was freed. Images come and go as blocks of a megabyte, and
/// getting such a block from the system again costs more than copying an image into it.
inline void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kLargestBlock = 32 << 20, kKept = 64 << 20;  // bytes; the first is glibc's limit
  mallopt(M_MMAP_THRESHOLD, kLargestBlock);
  mallopt(M_TRIM_THRESHOLD, kKept);
#endif
}

}  // namespace markerless_mocap
