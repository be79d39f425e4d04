#pragma once

#include <vector>

#include "markerless_mocap/segmentation/body_segmenter.h"
#include "segmentation/branch.h"
#include "segmentation/eigenmap.h"

namespace markerless_mocap {

/// Criterion for the end of a branch.
enum class SplineTermination {
  kOrigin,    ///< the spline's end is near the origin (Hsiao 2008, 3.1.4.2 B-3)
  kOutliers,  ///< many of the nodes of the fit lie far from the spline (Sundaresan; 3.1.4.1 B-4)
};

/// Finds branches by fitting splines in the embedding from the extremities inwards (Hsiao 2008,
/// 3.1.4). A branch starts at the free node furthest from the origin, with its nearest nodes. A
/// cubic spline of position over site value (projection on the principal direction, Eq. 3-8) is
/// fitted and propagated with the free nodes nearest to its end, until `stop` holds. The free nodes
/// near the curve belong to the branch. All lengths but the stop radius are
/// relative to the start's distance from the origin, all counts to the number of nodes.
/// \param count maximum number of branches; fewer are returned if no free node is left
std::vector<Branch> splinePropagationBranches(const Eigenmap& map, SplineTermination stop,
                                              int count, const SplineWalkOptions& options = {});

}  // namespace markerless_mocap
