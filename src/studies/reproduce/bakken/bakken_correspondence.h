#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Figure 7: frames of a capture in which the labels that follow the last frame exchange arms or
/// legs, while left and right are still told correctly. With all frames, and with every second and
/// every fourth, as of a person who moves faster; pruned below 0.08 of the longest path, as less
/// would leave few frames. {"every": list of {"step", "pairs": of successive frames that are
/// labelled right, "exchanged": pairs with an exchange, "astray": length of the longest run of
/// frames that are valid, but wrong}, "jpeg": such a pair with the smallest step, in base64,
/// "frame": its first frame, "step"; without an exchange there are only the lists}
Json followLabels(const Capture& capture, int edge);

}  // namespace markerless_mocap
