#pragma once

#include <set>
#include <vector>

#include "calibration/adjust/bundle.h"
#include "calibration/start/board_pose.h"

namespace markerless_mocap {

/// The adjustment of a whole rig: groups the views by the cameras' clocks, minimises, leaves out
/// outliers, and tells whether the clocks agree.
class RigAdjustment {
 public:
  /// All that is given must outlive this object. \param poses of the board, by view \param state
  /// what is adjusted, with the start of its cameras
  RigAdjustment(const Board& board, const std::vector<BoardView>& views,
                const std::vector<BoardPose>& poses, int threads, RigState* state)
      : board_(board), views_(views), poses_(poses), threads_(threads), state_(state) {}

  /// The camera's pose and time offset are kept.
  void hold(size_t camera) { held_.insert(camera); }
  const std::set<size_t>& held() const { return held_; }
  void freeOffsets() { offsets_free_ = true; }
  /// True if the time offsets are estimated.
  bool areOffsetsFree() const { return offsets_free_; }
  BundleOptions options() const;

  /// Groups the views into instants by the time offsets as they are.
  void regroup();
  /// Robustly, then without outliers.
  void run();
  /// Cameras whose stamps are late or early meet a moving board badly. If the offsets are clear,
  /// and let the cameras meet the board clearly better, they are kept and free from then on.
  void checkClocks();
  /// Corners that run() has left out.
  int outliers() const { return outliers_; }

 private:
  void regroupAndAdjust();
  void weighPoints();

  const Board& board_;
  const std::vector<BoardView>& views_;
  const std::vector<BoardPose>& poses_;
  int threads_;
  RigState* state_;
  std::set<size_t> held_;
  bool offsets_free_ = false;
  int outliers_ = 0;
};

}  // namespace markerless_mocap
