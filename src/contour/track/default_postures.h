#pragma once

#include <vector>

#include "contour/model/contour_pose.h"
#include "contour/track/contour_multi_hypothesis_tracker.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Upright, bent, crouching, seated, kneeling, crawling and lying poses in several directions,
/// about the centre of the hull: start poses for a search without a good proposal. The first twelve
/// are upright, bent and crouching in four directions each; the others are left out if the hull is
/// too high or too low for them. Empty for an empty hull.
std::vector<ContourPose> defaultPostures(const VisualHull& hull);

/// Adds default postures to proposals of which none fits well.
void completeProposals(const ContourMultiHypothesisTracker& tracker, const ContourObservation& seen,
                       const ContourBody& body, const VisualHull& hull,
                       std::vector<ContourPose>& poses);

}  // namespace markerless_mocap
