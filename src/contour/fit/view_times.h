#pragma once

#include <vector>

#include "contour/fit/contour_observation.h"
#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// The motion of a body about a time.
struct ContourMotion {
  ContourPose pose;
  PoseIncrement velocity;  ///< per second
};

/// Says where a moving body is in each view, if the views are not of one time.
/// \param later_s by camera, how much later than the observation the view was taken, s; empty: all
///   views are of its time
void shiftViews(const ContourBody& body, const ContourMotion& motion,
                const std::vector<double>& later_s, ContourObservation* seen);

/// The body as a view shows it. \param cones at the time of the observation
ContourWorldCones conesIn(const ContourView& view, const ContourWorldCones& cones);

}  // namespace markerless_mocap
