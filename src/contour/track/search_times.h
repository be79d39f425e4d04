#pragma once

#include <algorithm>
#include <cstdint>

namespace markerless_mocap {

/// The first multiple of an interval after a stamp, nanoseconds. What is done at such instants, and
/// not at intervals since something has happened, is done in the same frames whenever the tracker
/// was started: results of two parts of a recording agree where they overlap.
inline int64_t nextInstant(int64_t stamp_ns, int64_t interval_ns) {
  return (stamp_ns / interval_ns + 1) * interval_ns;
}

/// When something is done that is done once in an interval at most. Stamps and intervals are
/// nanoseconds.
class SearchTimer {
 public:
  explicit SearchTimer(int64_t interval_ns) : interval_ns_(interval_ns) {}
  bool isDue(int64_t stamp_ns) const { return stamp_ns >= next_ns_; }
  /// It has been done; the next instant of the interval is the next time.
  void done(int64_t stamp_ns) { next_ns_ = nextInstant(stamp_ns, interval_ns_); }
  void dueNow() { next_ns_ = 0; }
  void dueAt(int64_t stamp_ns) { next_ns_ = stamp_ns; }

 private:
  int64_t interval_ns_, next_ns_ = 0;
};

/// The same, but the interval doubles after each time without success, up to a longest one.
class PatientSearchTimer {
 public:
  PatientSearchTimer(int64_t shortest_ns, int64_t longest_ns)
      : shortest_ns_(shortest_ns), longest_ns_(longest_ns) {}
  bool isDue(int64_t stamp_ns) const { return stamp_ns >= next_ns_; }
  void done(int64_t stamp_ns, bool success) {
    interval_ns_ = success ? shortest_ns_ : std::clamp(2 * interval_ns_, shortest_ns_, longest_ns_);
    next_ns_ = nextInstant(stamp_ns, interval_ns_);
  }
  /// Later times follow each other as after a success.
  void beImpatient() { interval_ns_ = 0; }
  void reset() { interval_ns_ = next_ns_ = 0; }

 private:
  int64_t shortest_ns_, longest_ns_, interval_ns_ = 0, next_ns_ = 0;
};

}  // namespace markerless_mocap
