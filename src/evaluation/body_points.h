#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Names of the points at hands, feet and head: l_hand (knuckles), l_hand_tip, l_foot (ball of the
/// foot), l_foot_tip, the same with r_, head_top.
const std::vector<std::string>& tipNames();

/// markerNames() followed by tipNames().
std::vector<std::string> bodyPointNames();

/// World positions of bodyPointNames(), metres, as columns; NaN if the link's frame is NaN. Tips
/// are the ends of the shape: the rounded end of the longest cone of hand and foot, and the highest
/// point of the head. Knuckles are at 0.53 of the hand, the ball of the foot at 0.72 of the foot
/// from the heel. Throws std::invalid_argument if hand, foot or head have no shape.
Eigen::Matrix3Xd bodyPoints(const BodyModel& model, const LinkPoses& T_world_link);

/// World z of the lowest point of the shapes of the left and the right foot, metres; NaN if the
/// link's frame is NaN. Throws std::invalid_argument if a foot has no shape.
Eigen::Vector2d soleHeights(const BodyModel& model, const LinkPoses& T_world_link);

}  // namespace markerless_mocap
