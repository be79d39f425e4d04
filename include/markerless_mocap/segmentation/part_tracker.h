#pragma once

#include <memory>

namespace markerless_mocap {

class PartMemory;

/// State of BodySegmenter::segment() from frame to frame for one person. Use one per sequence.
class PartTracker {
 public:
  PartTracker();
  ~PartTracker();
  PartTracker(PartTracker&&) noexcept;
  PartTracker& operator=(PartTracker&&) noexcept;

 private:
  friend class BodySegmenter;
  std::unique_ptr<PartMemory> memory_;
};

}  // namespace markerless_mocap
