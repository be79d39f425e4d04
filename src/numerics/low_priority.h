#pragma once

#include <sys/resource.h>
#include <tbb/task_arena.h>

namespace markerless_mocap {

/// Runs a function in this thread, which keeps a low priority from then on, and on no other core:
/// what has to keep up with cameras goes first.
template <class Function>
auto unobtrusively(const Function& function) {
  constexpr int kNiceness = 10;
  setpriority(PRIO_PROCESS, 0, kNiceness);  // of this thread only
  return tbb::task_arena(1).execute(function);
}

}  // namespace markerless_mocap
