#pragma once

#include <cstddef>
#include <vector>

#include "checks/motion/rig_model.h"

namespace markerless_mocap {

/// Offsets to a part of the time between images: each camera against the points of all others.
/// \param root the camera whose offset stays
/// \param reach how wrong they may be, s
/// \param offsets of the cameras of the model, s; those that are NaN stay so
void refineOffsets(const RigSight& sight, const RigModel& model, size_t root, double reach,
                   std::vector<double>* offsets);

/// How far the person goes by the cameras with these offsets, see walkedIn(), m.
double walkedAt(const RigSight& sight, const RigModel& model, const std::vector<double>& offsets);

}  // namespace markerless_mocap
