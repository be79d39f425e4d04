#pragma once

#include "evaluation/label_error.h"
#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

static_assert(kLabelledExtremityCount == kExtremityCount);

/// What a pose tree says about the ends of a body and their limbs.
LabelledExtremities labelsOf(const PoseTree& tree);

}  // namespace markerless_mocap
