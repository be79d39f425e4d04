#pragma once

#include "markerless_mocap/products/pose_tree.h"
#include "skeleton/labelling/left_right.h"

namespace markerless_mocap {

/// Fills the joints of a tree whose sides are told: wrists, elbows, ankles and knees at shares of
/// the longest path along their limbs from knuckles and balls of the feet, the neck on the trunk's
/// path from the head down, shoulders and hips beside it. The shares were fitted on people of the
/// virtual studio. A joint is left out where the arm is not as long on its own.
void placeJoints(const BodyAxes& axes, double longest, PoseTree* tree);

}  // namespace markerless_mocap
