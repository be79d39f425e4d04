#pragma once

#include <vector>

#include "silhouette/recording/color_candidates.h"
#include "silhouette/recording/person_colors.h"

namespace markerless_mocap {

/// Extends the known background inward: a pixel beside known ones takes the candidate that is like
/// them, frequent, and not a person's colour. If no candidate is good enough it stays unknown.
void floodInward(const std::vector<PixelCandidates>& candidates, const PersonColors& person,
                 SceneColors* scene);

}  // namespace markerless_mocap
