#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/segmentation/body_parts.h"
#include "markerless_mocap/segmentation/voxel_graph.h"

namespace markerless_mocap {

/// Curve through one part (Hsiao 2008, 3.1.5.2): the part's own one-dimensional eigenmap gives each
/// node its site value, and a cubic spline is fitted to position over site value (Eq. 3-16). The
/// Fiedler vector of a chain is cos(pi x) over the arc length x; its arc cosine is taken, so that
/// site values run evenly along the part.
/// \param nodes of the part; of several components the largest is used
/// \param ahead a number for each node of the whole graph that grows from the part's torso end to
///   its tip: it gives the curve its direction
/// \param modes the site value is the combination of these many lowest modes that comes nearest to
///   `ahead`: with 1 the Fiedler vector alone; more for a part whose Fiedler vector may run
///   sideways, as a torso's with the stumps of arms and legs
/// \return 21 points; `seen` is false for fewer than 8 nodes
PartCurve fitPartCurve(const VoxelGraph& voxels, const std::vector<uint32_t>& nodes,
                       const std::vector<double>& ahead, int modes);

}  // namespace markerless_mocap
