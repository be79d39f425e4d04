#pragma once

#include <deque>
#include <utility>

#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// Passes results on in their order. Those without a pose are held back, up to
/// Pipeline::kMostEarlierPoses, as a later one may bring it.
class HeldResults {
 public:
  explicit HeldResults(Pipeline::Sink sink) : sink_(std::move(sink)) {}
  void add(const FrameSet& frame_set, PipelineResult result);
  /// Passes on what is held. Call this after the last result.
  void passOn();

 private:
  struct Held {
    FrameSet frame_set;
    PipelineResult result;
  };

  void passOldestOn();
  /// The first of the poses takes the status of `pose`, which continues them.
  void takeEarlierPoses(const std::vector<EarlierPose>& earlier, BodyPose& pose);

  Pipeline::Sink sink_;
  std::deque<Held> held_;
};

}  // namespace markerless_mocap
