#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "markerless_mocap/camera/stamp_phases.h"

namespace markerless_mocap {

/// Counts of a FrameSetAssembler since its construction or last reset().
struct AssemblerCounts {
  uint64_t complete = 0;    ///< frame sets returned with all streams
  uint64_t incomplete = 0;  ///< frame sets returned after the deadline with enough streams
  uint64_t abandoned = 0;   ///< frame sets dropped: too few streams at the deadline, or time jumped
  uint64_t duplicate = 0;   ///< items whose stream already had an item in this frame set
  uint64_t late = 0;        ///< items older than the last returned frame set or than the deadline
  uint64_t far_future = 0;  ///< items more than `max_jump` ahead of the newest
  uint64_t overflow = 0;    ///< frame sets closed before the deadline, as too many waited
  uint64_t time_jumps_back = 0;  ///< restarts because time went backwards
};

/// Settings of FrameSetAssembler; times in seconds of capture stamps.
struct AssemblerOptions {
  double tolerance = 0.005;  ///< stamps closer than this belong to one frame set
  double deadline = 0.1;     ///< a frame set older than the newest stamp by this is closed
  double max_jump = 5.0;     ///< a stamp further ahead than this is not accepted at first
  int min_streams = 2;
  int max_pending = 16;  ///< number of frame sets that wait; the oldest of more are closed
  /// Added to the stamps of each stream, for streams with other clocks; empty: nothing.
  std::vector<double> offsets;
  /// Lags up to this are followed, as of clocks that drift, of streams that are in step; 0: they
  /// are measured, no more.
  double max_drift = 0.0;
  /// A stream from which nothing came for this long, and three times as long as usual, while others
  /// send, is not waited for until it sends again; 0: it is waited for up to the deadline.
  double silence = 0.0;
  /// A stream that lacked in this many frame sets of most streams in a row is not waited for until
  /// its stamps fit again; 0: it is always waited for.
  int max_missed = 0;
  /// What is done with streams of the same rate whose stamps are apart by more than the tolerance.
  OutOfStep out_of_step = OutOfStep::kLeaveOut;

  /// Throws std::invalid_argument if a value is out of range `min_streams` is above `streams`, or
  /// there is another number of offsets than of streams.
  void validate(size_t streams) const;
};

/// How one stream's stamps lie to those of the others.
struct StreamTiming {
  double lag = 0.0;       ///< s, behind the median of the streams; a mean over some 100 frame sets
  uint64_t left_out = 0;  ///< frame sets that were returned without this stream
  /// s, from the last of those to the stream's nearest item since; empty if there was none.
  std::optional<double> nearest;
  bool awaited = true;  ///< whether frame sets wait for this stream
};

/// The lags of streams, slowly averaged.
class LagEstimate {
 public:
  explicit LagEstimate(size_t streams) : lags_ns_(streams, 0.0), counts_(streams, 0) {}

  /// \param lag_ns of one item of the stream
  void add(size_t stream, double lag_ns);
  double lag_ns(size_t stream) const { return lags_ns_[stream]; }
  /// Measures all lags from their median.
  void centre();
  void reset();

 private:
  std::vector<double> lags_ns_;
  std::vector<uint64_t> counts_;
};

/// Which of some streams still send. Time is that of the newest stamp, ns, but goes on by no more
/// than a third of the allowed silence at once: where all streams have paused, none is silent.
class StreamPresence {
 public:
  /// \param silence as AssemblerOptions::silence
  StreamPresence(size_t streams, double silence) : silence_(silence), streams_(streams) {}

  void arrived(size_t stream, int64_t newest_ns);
  bool isSilent(size_t stream) const;
  void reset();

 private:
  struct State {
    int64_t last_ns = 0;
    double gap_ns = 0.0;  ///< usual time between two items
    uint64_t count = 0;
  };
  double silence_;
  std::vector<State> streams_;
  std::optional<int64_t> newest_ns_;
  int64_t now_ns_ = 0;
};

/// Joins the items of N streams into frame sets by their stamps. It uses no clock: time is given by
/// the stamps. Items of one stream come in the order of their stamps, so a complete frame set
/// closes the older ones.
///
/// Streams with other clocks have offsets. If clocks drift as well, each stream's lag is followed:
/// its mean so far is taken off the stamps, so that only what is left must be within the tolerance.
///
/// A stamp that is far ahead, or older than the deadline, is not accepted at first. If more streams
/// send such stamps (twice in a row) than plausible ones, time has jumped: a bag loops, or a clock
/// was set. The same holds for stamps before the stream's last one that come too late for their
/// frame set. Then all state but the counts is discarded, and the assembler continues with those
/// items.
///
/// `Item` must be cheap to move, for example a shared pointer.
template <class Item>
class FrameSetAssembler {
 public:
  struct FrameSet {
    /// The mean of the items' stamps, with offset and without lag: the time that a body in motion
    /// is seen at, on the whole, where cameras are not in step.
    int64_t stamp_ns = 0;
    std::vector<Item> items;  ///< one per stream; default-constructed where missing
    std::vector<bool> present;
    std::vector<int64_t> stamps_ns;  ///< one per stream, with offset and without lag; 0: missing

    /// By how much a stream's item is later than `stamp_ns`, s; 0 if it is missing.
    double laterBy(size_t stream) const {
      return present[stream] ? 1e-9 * double(stamps_ns[stream] - stamp_ns) : 0.0;
    }
  };

  /// Throws std::invalid_argument as AssemblerOptions::validate().
  FrameSetAssembler(size_t streams, const AssemblerOptions& options);

  /// Adds one item and returns the frame sets that it completed or closed, oldest first. Throws
  /// std::invalid_argument if there is no such stream.
  std::vector<FrameSet> add(size_t stream, int64_t stamp_ns, Item item);
  /// Returns all pending frame sets that have enough streams (at the end of a recording).
  std::vector<FrameSet> flush();
  /// Discards all state and sets the counts to 0.
  void reset();
  const AssemblerCounts& counts() const { return counts_; }
  /// Lag with the stream's offset applied, and how often it was left out since the construction or
  /// the last reset(). Throws std::out_of_range if there is no such stream.
  StreamTiming timing(size_t stream) const;
  /// Stamps closer than this belong to one frame set, s: the given one, or more for streams that
  /// are out of step and joined.
  double tolerance() const { return 1e-9 * double(phases_.tolerance_ns()); }
  /// Says when a stream will have stamps, so that streams out of step are joined from the first one
  /// on. Throws std::invalid_argument if there is no such stream.
  void foresee(size_t stream, int64_t stamp_ns);

 private:
  using Pending = std::map<int64_t, FrameSet>;

  void requireStream(size_t stream) const;

  enum class StampCheck { kPlausible, kTooOld, kFarFuture };

  /// A recent arrival. `item` is kept only if the stamp was not plausible.
  struct Arrival {
    size_t stream;
    StampCheck check;
    int64_t stamp_ns;
    Item item;
  };

  /// With the offset and without the lag that is followed.
  int64_t commonTime(size_t stream, int64_t stamp_ns) const;
  int64_t followedLag(size_t stream) const;
  /// Later than that of the frame set before.
  int64_t meanStamp(const FrameSet& frame_set) const;
  void measureLags(const FrameSet& frame_set);
  void noteMissing(const FrameSet& frame_set);
  StampCheck checkStamp(size_t stream, int64_t stamp_ns);
  bool wentBack(size_t stream, int64_t stamp_ns);
  bool isAwaited(size_t stream) const;
  bool isMost(const std::vector<bool>& present) const;
  /// Whether all streams that are waited for are there.
  bool isReady(const FrameSet& frame_set) const;
  /// Whether it has a stream that is waited for, if any is.
  bool hasAwaited(const FrameSet& frame_set) const;
  void noteMissed(const FrameSet& frame_set);
  /// A stream that is not waited for comes back if its stamps fit a frame set of most streams.
  void takeBack(size_t stream, int64_t stamp_ns);
  /// ns, from the nearest of the last frame sets of most streams.
  int64_t fromNearestClosed(int64_t stamp_ns) const;
  bool sentLately(size_t stream) const;
  void remember(Arrival arrival);
  /// Adds the item to its frame set, or counts it as dropped.
  void insert(size_t stream, int64_t stamp_ns, Item item);
  typename Pending::iterator findPending(int64_t stamp_ns);
  bool wasInLastFrameSet(size_t stream, int64_t stamp_ns) const;
  std::vector<FrameSet> takeReady();
  /// Removes the oldest pending frame set; appends it to `out` if it has enough streams.
  void closeOldest(std::vector<FrameSet>* out);
  /// Streams out of step are waited for, whatever the rate.
  int64_t deadline_ns() const { return std::max(deadline_ns_, phases_.tolerance_ns()); }
  /// Whether enough streams agree that time jumped back (kTooOld) or forward (kFarFuture).
  bool timeHasJumped(StampCheck jump_kind) const;
  std::vector<FrameSet> restartAtJump(StampCheck jump_kind);
  /// Discards all state but the counts.
  void forget();

  size_t streams_;
  AssemblerOptions options_;
  int64_t deadline_ns_, max_jump_ns_;
  std::vector<int64_t> offsets_ns_;
  AssemblerCounts counts_;
  std::vector<uint64_t> left_out_;
  std::vector<std::optional<double>> nearest_;
  LagEstimate lags_;
  StreamPresence presence_;
  StampPhases phases_;
  std::vector<int> missed_;  ///< frame sets of most streams in a row without the stream
  std::vector<std::optional<int64_t>> newest_of_ns_;  ///< by stream
  std::deque<int64_t> closed_ns_;                     ///< the last frame sets of most streams
  Pending pending_;
  std::optional<int64_t> newest_ns_;
  std::optional<int64_t> last_out_ns_;   ///< stamp of the first item of the last frame set
  std::optional<int64_t> last_mean_ns_;  ///< FrameSet::stamp_ns of the last frame set
  std::vector<bool> last_out_present_;
  std::deque<Arrival> recent_;  ///< up to three per stream
};

}  // namespace markerless_mocap

#include "markerless_mocap/camera/frame_set_assembler_impl.h"
