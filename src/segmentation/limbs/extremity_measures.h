#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "segmentation/voxel_graph.h"

namespace markerless_mocap {

/// Measures by which extremities are assigned to parts. Sizes that hardly depend on the pose are
/// natural logarithms. Lengths are geodesic distances inside the hull in units of the cube root of
/// its volume, so they do not depend on stature or pitch.
struct ExtremityMeasures {
  std::vector<double> to_core;   ///< distance from the extremity to the thick core
  std::vector<double> fullness;  ///< volume of the nodes within a distance of 0.6 units from the
                                 ///< extremity, cubic units
  std::vector<double> height;    ///< 0 at the lowest node to 1 at the highest (no logarithm)
  Eigen::MatrixXd distance;      ///< distance between two extremities; 0 on the diagonal
  /// Distances from each extremity to all nodes, units (no logarithm)
  std::vector<std::vector<double>> geodesic;
};

/// \param extremities distinct nodes
/// \param core nodes of the thick core, not empty
ExtremityMeasures measureExtremities(const VoxelGraph& voxels,
                                     const std::vector<uint32_t>& extremities,
                                     const std::vector<uint32_t>& core);

}  // namespace markerless_mocap
