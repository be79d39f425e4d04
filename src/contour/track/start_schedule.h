#pragma once

#include <cstdint>
#include <optional>

namespace markerless_mocap {

/// When the person is searched for, and when the pose of a start is checked by another search. A
/// search takes as long as following the person over many frames, so the longer nothing is found,
/// the longer it rests. Stamps are capture times, nanoseconds.
class StartSchedule {
 public:
  /// A search begins. \param by_color colours decide, which takes longer
  void startBegins(int64_t stamp_ns, bool by_color);
  /// Whether a hull shows somebody at a start. Whoever has just come is searched for without rest.
  void noteHull(int64_t stamp_ns, bool somebody_there);
  bool isSomebodyThere() const { return somebody_there_; }
  /// True for some time after a search.
  bool rests(int64_t stamp_ns) const { return stamp_ns < next_start_ns_; }
  /// A pose has been reported: nothing is searched for any more.
  void poseReported() { searching_since_ns_.reset(); }

  /// True if enough time has passed since the start or the last check.
  bool isCheckDue(int64_t stamp_ns) const { return stamp_ns >= next_check_ns_; }
  void checkNow() { next_check_ns_ = 0; }
  /// From now on checks come the more seldom the longer no pose is reported.
  void searchBegins(int64_t stamp_ns) {
    if (!searching_since_ns_) searching_since_ns_ = stamp_ns;
  }
  void checkBegins(int64_t stamp_ns);
  void colorCheckBegins(int64_t stamp_ns);
  /// A check by colour has led to the same pose.
  void confirm() { ++color_confirmations_; }
  /// It has led to another pose, which is to be checked soon.
  void contradict(int64_t stamp_ns);
  bool isConfirmed() const { return color_confirmations_ > 0; }
  /// True until checks by colour have confirmed the pose often enough, or there were many.
  bool wantsColorChecks() const;

 private:
  /// Time to the next search, longer the longer nothing is found; at least the given one.
  int64_t restAfterSearch(int64_t stamp_ns, int64_t least_ns) const;

  std::optional<int64_t> searching_since_ns_;  ///< no pose has been reported since
  int64_t next_start_ns_ = 0, next_check_ns_ = 0;
  int color_checks_ = 0, color_confirmations_ = 0;  ///< since the last start
  bool somebody_there_ = false;                     ///< at the last start
};

}  // namespace markerless_mocap
