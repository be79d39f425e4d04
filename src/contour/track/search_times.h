#pragma once

#include <cstdint>

namespace markerless_mocap {

/// The first multiple of an interval after a stamp, nanoseconds. What is done at such instants, and
/// not at intervals since something has happened, is done in the same frames whenever the tracker
/// was started: results of two parts of a recording agree where they overlap.
inline int64_t nextInstant(int64_t stamp_ns, int64_t interval_ns) {
  return (stamp_ns / interval_ns + 1) * interval_ns;
}

}  // namespace markerless_mocap
