#pragma once

#include <string>

#include "exports/person_motion.h"

namespace markerless_mocap {

/// The motion of a person in a bag with results: /tf, /pose and the URDF. Throws std::runtime_error
/// or std::invalid_argument as readResults(), if no frame has a pose, or if the bag has no URDF and
/// none is given.
/// \param id empty: the only body
/// \param urdf_file replaces the bag's description; empty: the bag's
PersonMotion readPersonMotion(const std::string& path, const std::string& id,
                              const std::string& urdf_file);

}  // namespace markerless_mocap
