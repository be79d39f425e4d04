#pragma once

#include <memory>

namespace markerless_mocap {

class PartMemory;

/// What BodySegmenter::segment() remembers of one person from frame to frame: one for each
/// sequence.
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
