#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

VoxelGrid messageFromLattice(const VoxelLattice& lattice, const std_msgs::Header& header);

/// Throws std::invalid_argument if the origin is not finite, or if the pitch or a size is not
/// positive.
VoxelLattice latticeFromMessage(const VoxelGrid& grid);

/// One point per voxel centre, metres: x y z rgb (float32), views, votes_x votes_y votes_z,
/// possible_x possible_y possible_z (uint8; see ColorVotes). No points if the hull is unusable.
sensor_msgs::PointCloud2 messageFromHull(const VisualHull& hull, const std_msgs::Header& header);

/// The hull from its points. A cloud without points gives kNobody with a reason. The component
/// volumes are not part of the message. Throws std::invalid_argument if a field is missing, if the
/// frames differ, or if a point (NaN included) is not the centre of a voxel of the grid.
VisualHull hullFromMessage(const sensor_msgs::PointCloud2& cloud, const VoxelGrid& grid);

}  // namespace markerless_mocap
