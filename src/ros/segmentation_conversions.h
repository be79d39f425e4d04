#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <cstdint>

#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

/// Colour of a part in all displays, red green blue.
std::array<uint8_t, 3> partColor(PartLabel label);

/// Status, reason and the six curves; voxel labels are published as labelledCloud().
BodyPartsMsg messageFromParts(const BodyParts& parts, const std_msgs::Header& header);

/// The parts from their message, without labels. Throws std::invalid_argument on an unknown status
/// or label, a curve whose points and site values differ in number, or a value that is not finite.
BodyParts partsFromMessage(const BodyPartsMsg& message);

/// x y z rgb (float32; colour of the part, darker if it is carried over from earlier frames) and
/// label (uint8, PartLabel) of each hull voxel, metres. No points if the parts have no labels.
/// Throws std::invalid_argument if hull and labels differ in number.
sensor_msgs::PointCloud2 labelledCloud(const VisualHull& hull, const BodyParts& parts,
                                       const std_msgs::Header& header);

/// Labels of the points, in the order of the cloud. Throws std::invalid_argument without a label
/// field or on an unknown label.
std::vector<uint8_t> labelsFromMessage(const sensor_msgs::PointCloud2& cloud);

/// One line strip per part in the colour of the part; parts that are not seen are deleted.
visualization_msgs::MarkerArray curveMarkers(const BodyParts& parts,
                                             const std_msgs::Header& header);

}  // namespace markerless_mocap
