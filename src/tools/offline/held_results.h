#pragma once

#include <deque>
#include <functional>
#include <utility>

#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// Passes results on in their order. Those without a pose are held back, as a later one may bring
/// it (PipelineResult::earlier_poses). A node cannot wait so long, a recording can: its poses begin
/// with the person, not with the time that it takes to find it.
class HeldResults {
 public:
  using Sink = std::function<void(const FrameSet&, const PipelineResult&)>;

  explicit HeldResults(Sink sink) : sink_(std::move(sink)) {}
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

  Sink sink_;
  std::deque<Held> held_;
};

}  // namespace markerless_mocap
