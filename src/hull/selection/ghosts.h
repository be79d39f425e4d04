#pragma once

#include <vector>

#include "hull/selection/voxel_component.h"
#include "hull/voting/projection_table.h"

namespace markerless_mocap {

/// Sets `suspect_ghost` of the pieces that could be taken away without uncovering a silhouette
/// pixel in any camera: what such a piece covers, the others cover too. Voxels cover the pixels
/// around that of their centre as far as half a voxel reaches. The first eight pieces are judged,
/// the others are not suspect; nor is a piece that is alone. \param masks one per camera, valid for
/// voters
void markGhosts(const CameraRig& rig, const ProjectionTable& table,
                const std::vector<TileMask>& masks, CameraSet voters,
                std::vector<VoxelComponent>* components);

}  // namespace markerless_mocap
