#pragma once

#include <memory>
#include <string>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Path of a file that belongs to the package, such as "urdf/human.urdf.in". Throws
/// std::runtime_error if ROS does not find the package.
std::string packageFile(const std::string& relative_path);

/// Text of a file. Throws std::runtime_error if it cannot be read.
std::string readText(const std::string& path);

/// URDF of a person from the template. Throws as loadBody().
std::string bodyUrdf(const std::string& template_path, const std::string& id, double stature);

/// The body of a person from the URDF template. Throws std::runtime_error or std::invalid_argument
/// when the template cannot be read or gives no body, or the stature is out of range.
/// \param template_path empty: the package's own
/// \param stature metres
std::shared_ptr<const BodyModel> loadBody(const std::string& template_path, const std::string& id,
                                          double stature);

}  // namespace markerless_mocap
