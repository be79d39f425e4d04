#pragma once

#include <string>

namespace markerless_mocap {

/// A sentence that says that the metre of the calibration seems to be wrong, and by how much; empty
/// if a person may have this stature. \param stature as measured, metres
std::string scaleFinding(double stature);

}  // namespace markerless_mocap
