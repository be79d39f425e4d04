#pragma once

#include <vector>

#include "hull/selection/voxel_component.h"
#include "hull/voting/projection_table.h"

namespace markerless_mocap {

/// Sets `suspect_ghost` of each component that covers no silhouette pixel that the other components
/// do not cover, in any camera. A voxel covers the pixels within half a voxel of its centre. Only
/// the first eight components are tested; the others are not suspected, nor is a single component.
/// \param masks one per camera, valid for voters
void markGhosts(const CameraRig& rig, const ProjectionTable& table,
                const std::vector<TileMask>& masks, CameraSet voters,
                std::vector<VoxelComponent>* components);

}  // namespace markerless_mocap
