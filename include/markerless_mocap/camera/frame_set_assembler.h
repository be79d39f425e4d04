#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace markerless_mocap {

/// Counts kept by FrameSetAssembler since construction or the last reset.
struct AssemblerCounts {
  uint64_t complete = 0;         ///< instants given out with every stream
  uint64_t incomplete = 0;       ///< given out after the deadline with enough streams
  uint64_t abandoned = 0;        ///< dropped: too few streams at the deadline, or time jumped
  uint64_t duplicate = 0;        ///< item whose stream already had this instant
  uint64_t late = 0;             ///< item older than the last instant given out or the deadline
  uint64_t far_future = 0;       ///< item more than `max_jump` ahead of the newest
  uint64_t overflow = 0;         ///< oldest pending instant dropped because the queue was full
  uint64_t time_jumps_back = 0;  ///< resets because time went backwards
};

/// Settings of FrameSetAssembler; times in seconds of capture stamps.
struct AssemblerOptions {
  double tolerance = 0.005;  ///< stamps closer than this belong to one instant
  double deadline = 0.1;     ///< an instant older than the newest stamp by this is closed
  double max_jump = 5.0;     ///< a stamp further ahead than this is not believed at first
  int min_streams = 2;
  int max_pending = 16;  ///< instants waiting at most

  /// Throws std::invalid_argument: a value out of range, or `min_streams` above `streams`.
  void validate(size_t streams) const;
};

/// Joins N streams into instants by stamp. Knows no clock: time is what the stamps say.
/// Items of one stream come in the order of their stamps, so a complete instant closes the older
/// ones. A stamp that is far ahead or older than the deadline is not believed, until more streams
/// send such stamps (twice running) than do not: then time has really jumped (a bag that loops, a
/// clock that was set), all state but the counts is forgotten, and those items start the new time.
/// `Item` is cheap to move (a shared pointer).
template <class Item>
class FrameSetAssembler {
 public:
  struct FrameSet {
    int64_t stamp_ns = 0;     ///< of the first item that came
    std::vector<Item> items;  ///< one per stream; default-constructed where missing
    std::vector<bool> present;
  };

  /// Throws std::invalid_argument as AssemblerOptions::validate().
  FrameSetAssembler(size_t streams, const AssemblerOptions& options);

  /// Adds one item; returns the instants that it completed or closed, oldest first. Throws
  /// std::invalid_argument if there is no such stream.
  std::vector<FrameSet> add(size_t stream, int64_t stamp_ns, Item item);
  /// Gives out what is pending and has enough streams (end of a recording).
  std::vector<FrameSet> flush();
  /// Forgets all, counts included.
  void reset();
  const AssemblerCounts& counts() const { return counts_; }

 private:
  using Pending = std::map<int64_t, FrameSet>;

  enum class StampCheck { kPlausible, kTooOld, kFarFuture };

  /// A recent item; kept whole only while it is not believed.
  struct Arrival {
    size_t stream;
    StampCheck check;
    int64_t stamp_ns;
    Item item;
  };

  StampCheck checkStamp(int64_t stamp_ns) const;
  void remember(Arrival arrival);
  /// Puts the item where it belongs, or counts why it is dropped.
  void insert(size_t stream, int64_t stamp_ns, Item item);
  typename Pending::iterator findPending(int64_t stamp_ns);
  bool isLastOut(size_t stream, int64_t stamp_ns) const;
  std::vector<FrameSet> takeReady();
  /// Removes the oldest pending instant; appends it to `out` if it has enough streams.
  void closeOldest(std::vector<FrameSet>* out);
  /// Whether the streams agree that time is now where `doubt` says.
  bool timeHasJumped(StampCheck doubt) const;
  std::vector<FrameSet> restartAtJump(StampCheck doubt);
  /// Forgets all but the counts.
  void forget();

  size_t streams_;
  AssemblerOptions options_;
  int64_t tolerance_ns_, deadline_ns_, max_jump_ns_;
  AssemblerCounts counts_;
  Pending pending_;
  std::optional<int64_t> newest_ns_;
  std::optional<int64_t> last_out_ns_;
  std::vector<bool> last_out_present_;
  std::deque<Arrival> recent_;  ///< at most three per stream
};

}  // namespace markerless_mocap

#include "markerless_mocap/camera/frame_set_assembler_impl.h"
