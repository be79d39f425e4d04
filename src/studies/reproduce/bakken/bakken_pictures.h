#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Hulls, skeletons and pose trees of four frames as one camera sees them, as in Figures 5 and 6:
/// {"jpeg": base64}. Above as published, below with the learned labelling; an invalid tree is grey.
Json drawTrees(const Capture& capture, int edge);

}  // namespace markerless_mocap
