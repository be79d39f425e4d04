#include "markerless_mocap/tracking/body_tracker.h"

namespace markerless_mocap {

BodyTracker::~BodyTracker() = default;

}  // namespace markerless_mocap
