#pragma once

#include <string>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// Part of the body that a joint moves, from the joint's name without the id ("l_y_shoulder"). Limb
/// number 1 is the left one. A joint of no limb and not of the head belongs to the torso.
PartLabel partOfJoint(const std::string& base_name);

/// The part that a link of the body belongs to: that of the joint which leads to it.
PartLabel partOfLink(const BodyModel& model, int link);

}  // namespace markerless_mocap
