#pragma once

#include "contour/model/contour_body.h"
#include "contour/model/contour_pose.h"

namespace markerless_mocap {

/// The pose with front and back exchanged, for a body that fills the same space: the right limb
/// takes the position of the left one. Knees and ankles are straightened, because they bend in one
/// direction only.
ContourPose mirrored(const ContourBody& body, const ContourPose& pose);

/// The pose with the two legs exchanged.
ContourPose withLegsSwapped(const ContourBody& body, const ContourPose& pose);

}  // namespace markerless_mocap
