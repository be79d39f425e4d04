#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/products/body_parts.h"
#include "segmentation/voxel_graph.h"

namespace markerless_mocap {

/// Curve through one part (Hsiao 2008, 3.1.5.2). The part's own eigenmap gives each node its site
/// value, and a cubic spline is fitted to the positions over the site values (Eq. 3-16). Hsiao uses
/// the Fiedler vector alone. Here the combination of the first modes that is nearest to a given
/// ordering is used: the values of a Fiedler vector are dense at its ends, and a torso's may run
/// sideways from one shoulder to the other.
/// \param nodes nodes of the part, ascending; of several components the largest is used
/// \param ahead a value for each node of the whole graph that increases from the part's end at the
///   torso to its extremity; gives the curve its direction
/// \param modes number of modes to combine, >= 1; 1 is the Fiedler vector
/// \param pieces number of pieces of the spline, >= 1: one piece bends once or twice, five follow a
///   corner
/// \return 21 points; `seen` is false for fewer than 8 nodes
PartCurve fitPartCurve(const VoxelGraph& voxels, const std::vector<uint32_t>& nodes,
                       const std::vector<double>& ahead, int modes, int pieces);

}  // namespace markerless_mocap
