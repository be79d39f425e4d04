#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "markerless_mocap/segmentation/voxel_graph.h"

namespace markerless_mocap {

/// What tips are named by: natural logarithms of sizes that a pose hardly changes. Lengths are ways
/// inside the hull, in units of the cube root of its volume, so that neither stature nor pitch
/// matters.
struct TipMeasures {
  std::vector<double> to_core;   ///< way from the tip to the thick core
  std::vector<double> fullness;  ///< nodes within 0.6 units of way from the tip, of a cubic unit
  Eigen::MatrixXd distance;      ///< way between two tips; 0 on the diagonal
  std::vector<std::vector<double>> way;  ///< from each tip to every node, units (no logarithm)
};

/// \param tips distinct nodes
/// \param core nodes of the thick core, not empty
TipMeasures measureTips(const VoxelGraph& voxels, const std::vector<uint32_t>& tips,
                        const std::vector<uint32_t>& core);

}  // namespace markerless_mocap
