#pragma once

#include <memory>
#include <string>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/pipeline/eigen_layout.h"
#include "markerless_mocap/pipeline/tracker_options.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_resources.h"

namespace markerless_mocap {

/// What a method reads. A method without masks reads visual hull and body parts of each frame set,
/// the others read them as ProductSource says.
struct TrackerNeeds {
  bool masks = false;   ///< silhouettes and calibrations of all cameras
  bool images = false;  ///< images of all cameras
  bool colors = false;  ///< colour images of the cameras whose masks have hasUnknownBackground()
  /// a start takes as long as many frame sets, following less than the time between two
  bool starts_by_search = false;
};

/// Throws std::invalid_argument on an unknown method.
TrackerNeeds needsOf(const std::string& method);

/// Makes the tracker that options.method names. make_body_tracker.cpp is the only file that knows
/// all methods: a new method is added there and in TrackerOptions. Throws std::invalid_argument if
/// an option is out of range, if the URDF template describes no body, or if the rig has no cameras
/// and the method needs their masks.
std::unique_ptr<BodyTracker> makeBodyTracker(const CameraRig& rig, const PersonResources& resources,
                                             const TrackerOptions& options);

}  // namespace markerless_mocap
