#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace markerless_mocap {

/// What is done with streams of one rate whose stamps are apart from those of the others.
enum class OutOfStep {
  kLeaveOut,     ///< they are left out of frame sets
  kJoinIfNever,  ///< they are joined if most streams were out of step from the first stamps on: a
                 ///< camera that is alone, or comes out of step later, is one whose stamps are
                 ///< wrong
  kJoin          ///< they are joined
};

/// When, within one interval, each of several streams of one rate has its stamps, and how far apart
/// stamps of one frame set are therefore.
class StampPhases {
 public:
  /// \param tolerance_ns streams whose stamps are within it are in step
  StampPhases(size_t streams, OutOfStep rule, int64_t tolerance_ns);

  /// Stamps of one stream ascend.
  void add(size_t stream, int64_t stamp_ns);
  /// How far stamps of one frame set may be apart, ns: the least that was given, or, for streams to
  /// be joined, the shortest part of the interval in which all have their stamps and half of the
  /// rest. The given one as long as fewer than two streams are known, or their rates differ.
  int64_t tolerance_ns() const { return tolerance_ns_; }
  /// Whether streams are joined that are out of step.
  bool joinsApart() const { return tolerance_ns_ > least_ns_; }
  void reset();

 private:
  struct Step;
  std::vector<size_t> knownStreams() const;
  std::optional<Step> step(const std::vector<size_t>& known) const;
  void measure();

  OutOfStep rule_;
  int64_t least_ns_, tolerance_ns_;
  std::vector<std::deque<int64_t>> stamps_;  ///< the last of each stream, ns
  size_t added_ = 0;                         ///< stamps since the last measurement
  size_t judged_ = 0;                        ///< streams that were known when it was judged
  bool never_in_step_ = false;
};

}  // namespace markerless_mocap
