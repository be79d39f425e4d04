#pragma once

#include <string>

#include "ros/package_files.h"

namespace markerless_mocap {

/// URDF of a person with a stature (metres). Throws std::runtime_error or std::invalid_argument if
/// the template cannot be read or gives no body, or the stature is out of range.
/// \param template_path empty: the template of this package
std::string bodyUrdf(const std::string& template_path, const std::string& id, double stature);

}  // namespace markerless_mocap
