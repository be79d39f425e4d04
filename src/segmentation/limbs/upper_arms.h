#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "segmentation/limbs/limbs.h"

namespace markerless_mocap {

/// One side of a trunk, estimated from the end of the head, world metres.
struct TrunkSide {
  Eigen::Vector3d shoulder;
  Eigen::Vector3d hip;
};

/// Both sides of the trunk: in the direction in which the chest is widest, at human proportions
/// below the end of the head. Empty without a head or a chest.
std::optional<std::array<TrunkSide, 2>> findTrunkSides(const VoxelGraph& voxels,
                                                       const Limbs& limbs);

/// Extends arms to the shoulders. Arms end where the hull widens; this is at the elbow if the upper
/// arm lies against the trunk. Each arm gets the free nodes around the line from its end to its
/// shoulder that are nearer to this line than to the trunk's side.
void addUpperArms(const VoxelGraph& voxels, Limbs* limbs);

}  // namespace markerless_mocap
