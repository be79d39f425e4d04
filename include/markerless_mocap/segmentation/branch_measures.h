#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/segmentation/branch.h"
#include "markerless_mocap/segmentation/voxel_graph.h"

namespace markerless_mocap {

/// What branches are named by: natural logarithms of sizes that a pose hardly changes, lengths
/// against the cube root of the hull's volume, so that neither stature nor pitch matters.
struct BranchMeasures {
  struct Own {
    double volume_share;  ///< of the hull's nodes
    double length;        ///< way inside the hull from the tip to the thick core
    double thickness;     ///< mean depth of the branch's nodes under the surface
  };
  std::vector<Own> own;
  Eigen::MatrixXd tip_distance;  ///< way inside the hull between two tips; 0 on the diagonal
  std::vector<std::vector<double>> from_tip;  ///< way from each tip to every node, in voxels
};

/// \param core nodes of the thick core, not empty
BranchMeasures measureBranches(const VoxelGraph& voxels, const std::vector<Branch>& branches,
                               const std::vector<uint32_t>& core);

}  // namespace markerless_mocap
