#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "segmentation/voxel_graph.h"

namespace markerless_mocap {

/// What tips are named by. Sizes that a pose hardly changes are natural logarithms; lengths are
/// ways inside the hull, in units of the cube root of its volume, so that neither stature nor pitch
/// matters.
struct ExtremityMeasures {
  std::vector<double> to_core;   ///< way from the tip to the thick core
  std::vector<double> fullness;  ///< nodes within 0.6 units of way from the tip, of a cubic unit
  std::vector<double> height;    ///< from 0 at the lowest node to 1 at the highest (no logarithm)
  Eigen::MatrixXd distance;      ///< way between two tips; 0 on the diagonal
  std::vector<std::vector<double>> geodesic;  ///< from each tip to every node, units (no logarithm)
};

/// \param tips distinct nodes
/// \param core nodes of the thick core, not empty
ExtremityMeasures measureExtremities(const VoxelGraph& voxels,
                                     const std::vector<uint32_t>& extremities,
                                     const std::vector<uint32_t>& core);

}  // namespace markerless_mocap
