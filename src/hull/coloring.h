#pragma once

#include <vector>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// Gives voxels of one hull their mean colour and their colour votes.
/// \param voxels sorted by index
/// \param pixel_of_voxel [camera][voxel], -1 where the camera does not see the voxel
/// \param images one per camera, continuous; empty where there is none
void colorVoxels(const VoxelLattice& lattice,
                 const std::vector<std::vector<int32_t>>& pixel_of_voxel,
                 const std::vector<cv::Mat>& images, double color_vote_distance,
                 std::vector<HullVoxel>* voxels);

}  // namespace markerless_mocap
