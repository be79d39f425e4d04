#pragma once

#include "studies/common/bakken_variants.h"
#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// What is carved: the published cube of 2 m around the middle of the motion, or all of the studio
/// with voxels of the same size.
enum class Volume { kCube, kStudio };

/// Labels the hulls of a capture by every variant, without the frames in which the person reaches
/// out of the cube, as in the paper. {"seconds": time of each frame, "raised": 0 or 1, whether a
/// hand is above the centre of the head, <id of a variant>: {"right": 0 or 1 of each frame,
/// "correct", "valid", "rank", <extremity>: error of each frame, mm; "arm", "neck": own length of
/// the shorter arm and of the neck as fractions of the longest path, of the frames that are
/// right}}. A frame is correct if its five extremities are, and right if it is valid, too. Errors
/// are of the valid frames, to knuckles, balls of the feet and head's centre.
Json labelCapture(const Capture& capture, int edge, Volume volume);

/// Durations of the published stages for each frame, ms: {"hull", "thinning", "tree"}.
Json timeCapture(const Capture& capture, int edge);

}  // namespace markerless_mocap
