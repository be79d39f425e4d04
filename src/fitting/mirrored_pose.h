#pragma once

#include "markerless_mocap/contour/contour_body.h"

namespace markerless_mocap {

/// The pose of a body that fills the same space turned about: front becomes back, and what was the
/// left limb's place is the right one's. Knees and ankles straighten, as they bend to one side
/// only.
ContourPose mirrored(const ContourBody& body, const ContourPose& pose);

}  // namespace markerless_mocap
