#pragma once

#include <memory>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/pipeline/tracker_options.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_resources.h"

namespace markerless_mocap {

/// The only place that knows all methods: a new one is added here and in TrackerOptions.
/// Throws std::invalid_argument on options out of range, a URDF template that gives no body, or a
/// rig without cameras for a method that needs their masks.
std::unique_ptr<BodyTracker> makeBodyTracker(const CameraRig& rig, const PersonResources& sources,
                                             const TrackerOptions& options);

}  // namespace markerless_mocap
