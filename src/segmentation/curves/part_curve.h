#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/products/body_parts.h"
#include "segmentation/voxel_graph.h"

namespace markerless_mocap {

/// Curve through one part (Hsiao 2008, 3.1.5.2): the part's own eigenmap gives each node its site
/// value, and a cubic spline is fitted to position over site value (Eq. 3-16). Where Hsiao takes
/// the Fiedler vector alone, the combination of the few lowest modes that comes nearest to a given
/// ordering is taken: a Fiedler vector crowds its values at the ends, and a torso's may run
/// sideways from one shoulder's stump to the other's.
/// \param nodes of the part, ascending; of several components the largest is used
/// \param ahead a number for each node of the whole graph that grows from the part's torso end to
///   its tip: it gives the curve its direction
/// \param modes to combine, >= 1; with 1 the Fiedler vector
/// \param pieces of the spline, >= 1: one bends once or twice, five turn a corner
/// \return 21 points; `seen` is false for fewer than 8 nodes
PartCurve fitPartCurve(const VoxelGraph& voxels, const std::vector<uint32_t>& nodes,
                       const std::vector<double>& ahead, int modes, int pieces);

}  // namespace markerless_mocap
