#pragma once

#include <sched.h>
#include <tbb/task_arena.h>

namespace markerless_mocap {

/// Runs a function in this thread, which from then on works only while its core has nothing else to
/// do, and on no other core: what has to keep up with cameras goes first. A mere niceness is not
/// enough, a thread that is woken may wait for milliseconds then. Where all cores are always busy
/// it hardly gets on, so nothing that frame sets wait for may be run in this way.
template <class Function>
auto unobtrusively(const Function& function) {
  const sched_param none{};
  sched_setscheduler(0, SCHED_IDLE, &none);  // this thread only
  return tbb::task_arena(1).execute(function);
}

}  // namespace markerless_mocap
