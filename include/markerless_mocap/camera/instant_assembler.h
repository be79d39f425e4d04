#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Counts kept by InstantAssembler since construction or the last reset.
struct AssemblerCounts {
  uint64_t complete = 0;      ///< instants given out with every stream
  uint64_t incomplete = 0;    ///< given out after the deadline with enough streams
  uint64_t abandoned = 0;     ///< dropped after the deadline: too few streams
  uint64_t duplicate = 0;     ///< item whose stream already had this instant
  uint64_t late = 0;          ///< item older than the last instant given out
  uint64_t far_future = 0;    ///< item more than `max_jump` ahead of the newest
  uint64_t overflow = 0;      ///< oldest pending instant dropped because the queue was full
  uint64_t time_jumps_back = 0;  ///< resets because time went backwards
};

/// Settings of InstantAssembler; times in seconds of capture stamps.
struct AssemblerOptions {
  double tolerance = 0.005;      ///< stamps closer than this belong to one instant
  double deadline = 0.1;         ///< an instant older than the newest stamp by this is closed
  double max_jump = 5.0;         ///< a stamp further ahead than this is not believed at first
  int min_streams = 2;
  int max_pending = 16;          ///< instants waiting at most
};

/// Joins N streams into instants by stamp. Knows no clock: time is what the stamps say.
/// `Item` is cheap to move (a shared pointer).
template <class Item>
class InstantAssembler {
 public:
  struct Instant {
    int64_t stamp_ns = 0;      ///< of the first item that came
    std::vector<Item> items;   ///< one per stream; default-constructed where missing
    std::vector<bool> present;
  };

  InstantAssembler(size_t streams, const AssemblerOptions& options)
      : streams_(streams), options_(options) {}

  /// Adds one item; returns the instants that it completed or closed, oldest first.
  std::vector<Instant> add(size_t stream, int64_t stamp_ns, Item item);
  /// Gives out what is pending and has enough streams (end of a recording).
  std::vector<Instant> flush();
  void reset();
  const AssemblerCounts& counts() const { return counts_; }

 private:
  std::vector<Instant> takeReady(int64_t newest_ns);

  size_t streams_;
  AssemblerOptions options_;
  AssemblerCounts counts_;
  std::map<int64_t, Instant> pending_;
  int64_t newest_ns_ = INT64_MIN;
  int64_t last_out_ns_ = INT64_MIN;
  int far_future_run_ = 0;  ///< consecutive unbelievable stamps; a run of them is a real jump
};

}  // namespace markerless_mocap

#include "markerless_mocap/camera/instant_assembler_impl.h"
