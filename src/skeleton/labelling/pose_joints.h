#pragma once

#include "markerless_mocap/products/pose_tree.h"
#include "skeleton/labelling/left_right.h"

namespace markerless_mocap {

/// Fills the joints of a tree whose sides are known. Wrists, elbows, ankles and knees lie on the
/// paths of their limbs, at fractions of the longest path from the knuckles and the balls of the
/// feet. The neck lies on the trunk's path below the head, shoulders and hips beside that path. The
/// fractions were fitted to people of the virtual studio. A joint is left out if the limb's own
/// path is too short for it.
void placeJoints(const BodyAxes& axes, double longest, PoseTree* tree);

}  // namespace markerless_mocap
