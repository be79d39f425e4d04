#pragma once

#include "contour/model/contour_body.h"
#include "region/placed_body.h"

namespace markerless_mocap {

/// The body in its pose; its parts are its segments.
PlacedBody placedBody(const ContourBody& body, const ContourPose& pose);

}  // namespace markerless_mocap
