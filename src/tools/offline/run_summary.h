#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"
#include "tools/offline/reason_counts.h"

namespace markerless_mocap {

/// Counts and durations of one run over a recording, which starts with the constructor.
class RunSummary {
 public:
  static constexpr const char *kReading = "reading", *kWriting = "writing";

  /// \param with_trees whether a pose tree is made of every frame set
  explicit RunSummary(bool with_trees);

  /// What comes before the first frame set, the background and the person's measures, is done.
  void endPreparation() { prepared_ = Clock::now(); }
  /// Runs a step for one frame set and adds its duration; steps are the stages, kReading and
  /// kWriting. Thread-safe.
  void timed(const std::string& step, const std::function<void()>& work);
  void add(const PipelineResult& result);
  /// \param overlaps intersection over union of body and mask, one per view
  void addOverlaps(const std::vector<double>& overlaps);

  /// \param finding a sentence about the calibration; empty: none
  void setCalibrationFinding(std::string finding) { calibration_finding_ = std::move(finding); }
  const std::string& calibrationFinding() const { return calibration_finding_; }

  int frame_sets() const { return frame_sets_; }
  /// Number of frame sets after the background was learned.
  int processed() const { return frame_sets_ - learning_; }
  double meanIou() const { return views_ == 0 ? 0.0 : iou_sum_ / views_; }
  int poses() const { return tracked_ + reinitialized_; }

  void print(std::ostream& out) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Time {
    std::string step;
    double seconds;
    int runs;
  };

  void printReasons(std::ostream& out) const;
  void printTimes(std::ostream& out) const;

  Clock::time_point started_, prepared_;
  std::unique_ptr<std::mutex> times_mutex_ = std::make_unique<std::mutex>();
  std::vector<Time> times_;  ///< in the order of processing
  ReasonCounts reasons_;     ///< of lost poses
  int frame_sets_ = 0, learning_ = 0, tracked_ = 0, reinitialized_ = 0, lost_ = 0;
  int empty_hulls_ = 0;
  bool with_trees_;
  int valid_trees_ = 0;
  std::string calibration_finding_;
  double iou_sum_ = 0.0;
  int views_ = 0;  ///< number of compared views
};

}  // namespace markerless_mocap
