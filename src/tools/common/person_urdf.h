#pragma once

#include <string>

#include "ros/package_files.h"

namespace markerless_mocap {

/// URDF of a person of a stature (metres) from the template. Throws std::runtime_error or
/// std::invalid_argument when the template cannot be read or the stature is out of range.
/// \param template_path empty: the package's own
std::string bodyUrdf(const std::string& template_path, const std::string& id, double stature);

}  // namespace markerless_mocap
