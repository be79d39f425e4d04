#pragma once

#include <memory>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/pipeline/eigen_layout.h"
#include "markerless_mocap/pipeline/tracker_options.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_resources.h"

namespace markerless_mocap {

/// Makes the tracker that options.method names. This is the only place that knows all methods: a
/// new method is added here and in TrackerOptions. Throws std::invalid_argument if an option is out
/// of range, if the URDF template describes no body, or if the rig has no cameras and the method
/// needs their masks.
std::unique_ptr<BodyTracker> makeBodyTracker(const CameraRig& rig, const PersonResources& resources,
                                             const TrackerOptions& options);

}  // namespace markerless_mocap
