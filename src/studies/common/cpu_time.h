#pragma once

#include <ctime>

namespace markerless_mocap {

/// Seconds of processor time of this thread: what else runs on the machine does not count.
inline double threadSeconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

}  // namespace markerless_mocap
