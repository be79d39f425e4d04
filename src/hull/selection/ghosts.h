#pragma once

#include <vector>

#include "hull/voting/carving_plan.h"
#include "hull/selection/piece.h"

namespace markerless_mocap {

/// Sets `suspect_ghost` of the pieces that could be taken away without uncovering a silhouette
/// pixel in any camera: what such a piece covers, the others cover too. Voxels cover the pixels
/// around that of their centre as far as half a voxel reaches. The first eight pieces are judged,
/// the others are not suspect; nor is a piece that is alone. \param masks one per camera, valid for
/// voters
void markGhosts(const CameraRig& rig, const CarvingPlan& plan, const std::vector<TileMask>& masks,
                CameraSet voters, std::vector<Piece>* pieces);

}  // namespace markerless_mocap
