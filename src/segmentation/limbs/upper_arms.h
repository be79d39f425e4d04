#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "segmentation/limbs/limbs.h"

namespace markerless_mocap {

/// One side of a trunk, told from where its head ends, in world, metres.
struct TrunkSide {
  Eigen::Vector3d shoulder;
  Eigen::Vector3d hip;
};

/// Both sides, as people are built: across the chest they lie where it is widest, along the trunk
/// below the head's end. Nothing without a head or a chest.
std::optional<std::array<TrunkSide, 2>> findTrunkSides(const VoxelGraph& voxels,
                                                       const Limbs& limbs);

/// Arms end where the hull widens, which is at the elbow where the upper arm lies against the
/// trunk. This gives each arm the free nodes that lie around the line from its end to its shoulder
/// and nearer to that than to the trunk's side.
void addUpperArms(const VoxelGraph& voxels, Limbs* limbs);

}  // namespace markerless_mocap
