#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Figure 7: frames of a capture in which the labels that follow the last frame exchange arms or
/// legs, while left and right are still told correctly; pruned below 0.08 of the longest path, as
/// less would leave few frames. {"pairs": of successive frames that are labelled right,
/// "exchanged": pairs with an exchange, "jpeg": the first such pair in base64, "frame": number of
/// its first frame; without an exchange there are no such}
Json followLabels(const Capture& capture, int edge);

}  // namespace markerless_mocap
