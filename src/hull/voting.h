#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// One present camera: where it sees each voxel (-1: nowhere), and its silhouette (continuous).
struct Voter {
  const std::vector<int32_t>* pixel_of_voxel;
  cv::Mat mask;
  size_t set_pixels;  ///< of the mask
};

/// Indices, sorted, of the voxels below `voxel_count` that at least `min_views` voters see and all
/// but `missing_votes_allowed` of those have in their silhouette.
std::vector<uint32_t> voteForeground(std::vector<Voter> voters, uint32_t voxel_count, int min_views,
                                     int missing_votes_allowed);

}  // namespace markerless_mocap
