#pragma once

#include <string>
#include <utility>
#include <vector>

#include "evaluation/joint_track.h"
#include "skeleton/labelling.h"

namespace markerless_mocap {

/// Where the true points of a body lie on a tree that is labelled right, as fractions of its
/// longest path: names and values of the constants in extremity_position.cpp and pose_joints.cpp.
/// Those of limbs come twice, for left and right. \param truth one frame, with all
/// groundTruthNames()
std::vector<std::pair<std::string, double>> limbShares(const Labelling& labelling,
                                                       const PoseTree& tree,
                                                       const JointTrack& truth);

}  // namespace markerless_mocap
