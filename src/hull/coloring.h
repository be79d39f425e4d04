#pragma once

#include <vector>

#include "hull/surface_sight.h"
#include "markerless_mocap/hull/visual_hull.h"

namespace markerless_mocap {

/// Gives the voxels of a hull their mean colour over the cameras that see them, and their colour
/// votes, by the cameras that see both voxels. Voxels that no camera sees take the colour of the
/// voxel before them along x, the first ones that of the next, grey where there is none.
/// \param order the piece's voxels in lattice order
/// \param images one per camera; empty where there is none
/// \param voxels in the same order
void colorVoxels(SurfaceSight* sight, const Piece& piece, const std::vector<PieceVoxel>& order,
                 const std::vector<cv::Mat>& images, double color_vote_distance,
                 std::vector<HullVoxel>* voxels);

}  // namespace markerless_mocap
