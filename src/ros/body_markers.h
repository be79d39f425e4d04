#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// The body's surface where it is, one triangle list per part: green where the part's expected
/// error is a centimetre or less, over yellow to red where it is five or more, grey where it is
/// not told. Parts that are not seen, and all when the pose is lost, are deleted.
visualization_msgs::MarkerArray bodyMarkers(const BodyModel& model, const BodyPose& pose,
                                            const std_msgs::Header& header);

}  // namespace markerless_mocap
