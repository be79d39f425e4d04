#pragma once

#include <sys/syscall.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <cstdint>

namespace markerless_mocap {

/// Makes this thread one of low priority that gives way soon, as far as the kernel allows it. From
/// Linux 6.12 on niceness alone is not enough: whoever is woken waits until the slice of time ends,
/// which is some milliseconds by default.
inline void takeLowPriority() {
  // As sched_setattr(2) has it; Debian 12's C library does not.
  struct {
    uint32_t size, policy;
    uint64_t flags;
    int32_t nice;
    uint32_t priority;
    uint64_t slice_ns, deadline, period;
  } attributes{};
  attributes.size = sizeof attributes;
  attributes.nice = 10;
  attributes.slice_ns = 100000;  // the shortest
  syscall(SYS_sched_setattr, 0, &attributes, 0);
}

/// Runs a function in this thread, which keeps a low priority from then on, and on no other core:
/// what has to keep up with cameras goes first.
template <class Function>
auto unobtrusively(const Function& function) {
  takeLowPriority();
  return tbb::task_arena(1).execute(function);
}

}  // namespace markerless_mocap
