#pragma once

#include "evaluation/label_error.h"
#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

static_assert(kEndCount == kExtremityCount);

/// What a pose tree says about the ends of a body and their limbs.
LabelledEnds labelsOf(const PoseTree& tree);

}  // namespace markerless_mocap
