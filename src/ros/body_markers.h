#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// Markers of the body's surface, one triangle list per part. The colour shows the estimated
/// standard deviation of the part: green up to 1 cm, over yellow to red from 5 cm on, grey if there
/// is none. Parts that are not seen, and all parts of a lost pose, are deleted.
visualization_msgs::MarkerArray bodyMarkers(const BodyModel& model, const BodyPose& pose,
                                            const std_msgs::Header& header);

/// The colour of a part in bodyMarkers(). \param deviation_m NaN: unknown
std_msgs::ColorRGBA colorOfDeviation(double deviation_m);

/// How it stands with a pose, in a line or two: "tracked, 93 % overlap, error 14 mm", "not seen:
/// arm 1", "lost: ...".
std::string poseSummary(const BodyPose& pose);
/// poseSummary() above the person's head, or above where the person was last.
/// \param last_head where the head was last; set here; empty: nowhere, then a lost pose is told
///   above the origin
visualization_msgs::Marker poseTextMarker(const BodyModel& model, const BodyPose& pose,
                                          const std_msgs::Header& header,
                                          std::optional<Eigen::Vector3d>* last_head);

}  // namespace markerless_mocap
