#pragma once

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Frames of all links with the root at the origin and all angles zero.
LinkPoses zeroPose(const BodyModel& model);

/// The same. Throws std::invalid_argument if the axes of a link differ from those of the root.
LinkPoses uprightZeroPose(const BodyModel& model);

}  // namespace markerless_mocap
