#pragma once

#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {

/// Adds to the expected errors of the ends what the fit of a pose cannot know: that a body that was
/// not measured has other lengths, and that one that covers the silhouettes badly may be the wrong
/// body or in the wrong place.
void widenExpectedErrors(const TrackedBody& body, const PersonOptions& person, BodyPose& pose);

}  // namespace markerless_mocap
