#include "markerless_mocap/segmentation/part_tracker.h"

#include "segmentation/limbs/part_memory.h"

namespace markerless_mocap {

PartTracker::PartTracker() : memory_(std::make_unique<PartMemory>()) {}
PartTracker::~PartTracker() = default;
PartTracker::PartTracker(PartTracker&&) noexcept = default;
PartTracker& PartTracker::operator=(PartTracker&&) noexcept = default;

}  // namespace markerless_mocap
