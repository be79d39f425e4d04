#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// What stands in for the ends of hands, feet and head: l_hand (knuckles), l_hand_tip, l_foot (ball
/// of the foot), l_foot_tip, the same of r_, head_top.
const std::vector<std::string>& tipNames();

/// markerNames() followed by tipNames().
std::vector<std::string> bodyPointNames();

/// World positions of bodyPointNames(), metres, as columns; NaN where the link's frame is NaN. Tips
/// are the ends of the shape: the hand's and the foot's longest cone with its rounding, the head's
/// highest point. Knuckles are at 0.53 of the hand, the ball at 0.72 of the foot from the heel.
/// Throws std::invalid_argument if hand, foot or head have no shape.
Eigen::Matrix3Xd bodyPoints(const BodyModel& model, const LinkPoses& T_world_link);

/// World z of the lowest point of the left and the right foot's shape, metres; NaN where the link's
/// frame is NaN. Throws std::invalid_argument if a foot has no shape.
Eigen::Vector2d soleHeights(const BodyModel& model, const LinkPoses& T_world_link);

}  // namespace markerless_mocap
