#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

VoxelGrid messageFromLattice(const VoxelLattice& lattice, const std_msgs::Header& header);

/// Throws std::invalid_argument on a non-finite origin or a pitch or size that is not positive.
VoxelLattice latticeFromMessage(const VoxelGrid& grid);

/// One point per voxel at its centre, metres: x y z rgb (float32), views, votes_x votes_y votes_z,
/// possible_x possible_y possible_z (uint8; see ColorVotes). An unusable hull gives no points.
sensor_msgs::PointCloud2 messageFromHull(const VisualHull& hull, const std_msgs::Header& header);

/// The hull back from its points. A cloud without points gives kNobody with a reason; the
/// component volumes do not travel. Throws std::invalid_argument if a field is missing, the frames
/// differ, or a point (NaN included) is not the centre of a voxel of the grid.
VisualHull hullFromMessage(const sensor_msgs::PointCloud2& cloud, const VoxelGrid& grid);

}  // namespace markerless_mocap
