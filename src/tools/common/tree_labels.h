#pragma once

#include "evaluation/label_error.h"
#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

static_assert(kLabelledExtremityCount == kExtremityCount);

/// The extremities of a pose tree and the nodes of their limbs.
LabelledExtremities labelsOf(const PoseTree& tree);

}  // namespace markerless_mocap
