#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// Markers of the body's surface, one triangle list per part. The colour shows the estimated
/// standard deviation of the part: green up to 1 cm, over yellow to red from 5 cm on, grey if there
/// is none. Parts that are not seen, and all parts of a lost pose, are deleted.
visualization_msgs::MarkerArray bodyMarkers(const BodyModel& model, const BodyPose& pose,
                                            const std_msgs::Header& header);

}  // namespace markerless_mocap
