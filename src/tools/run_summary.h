#pragma once

#include <chrono>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// Counts and times of one run over a recording.
class RunSummary {
 public:
  RunSummary();

  /// To be called when a stage is done; its time runs from the last call of this or startInstant().
  void stageDone(const std::string& stage);
  void startInstant();
  void add(const PipelineResult& result);
  /// \param overlaps intersection over union of body and mask, one per view
  void addOverlaps(const std::vector<double>& overlaps);

  int instants() const { return instants_; }
  /// Instants after the background was learned.
  int processed() const { return instants_ - learning_; }
  double meanIou() const { return views_ == 0 ? 0.0 : iou_sum_ / views_; }
  int poses() const { return tracked_ + reinitialized_; }

  void print(std::ostream& out) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Reason {
    int count = 0;
    std::string example;
  };

  void printReasons(std::ostream& out) const;
  void printTimes(std::ostream& out) const;

  Clock::time_point started_, lap_;
  std::vector<std::pair<std::string, double>> stage_seconds_;  ///< in the order of processing
  std::map<std::string, Reason> reasons_;  ///< of lost poses, by sentence without its numbers
  int instants_ = 0, learning_ = 0, tracked_ = 0, reinitialized_ = 0, lost_ = 0;
  int valid_trees_ = 0;
  double iou_sum_ = 0.0;
  int views_ = 0;  ///< that have been compared
};

}  // namespace markerless_mocap
