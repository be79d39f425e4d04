#pragma once

#include <string>

#include "markerless_mocap/tracking/person_resources.h"

namespace markerless_mocap {

/// Path of a file of this package, such as "urdf/human.urdf.in". Throws std::runtime_error if ROS
/// does not find the package.
std::string packageFile(const std::string& relative_path);

/// Whether a file is there; asked, not opened, as opening a pipe blocks. False for an empty path.
bool isThere(const std::string& path);
/// Text of a file. Throws std::runtime_error if it cannot be read.
std::string readText(const std::string& path);
/// Throws std::runtime_error if the file cannot be written.
void writeText(const std::string& path, const std::string& text);

/// Text of a URDF template. Throws as readText(), or std::invalid_argument with the path if it is
/// none of a body.
std::string readUrdfTemplate(const std::string& path, const std::string& body_id);

/// Prior knowledge about the person. Throws std::runtime_error if a file cannot be read,
/// std::invalid_argument if its content is invalid.
/// \param urdf_template empty: the template of this package
/// \param body_file shape of the person, written by writeBodyFile(); empty: none
PersonResources readPersonResources(const std::string& body_id, const std::string& urdf_template,
                                    const std::string& body_file);

/// Writes the shape of a person atomically: the file is complete or unchanged. Throws
/// std::runtime_error if it cannot be written.
void writeBodyFile(const std::string& path, const ShapeParameters& shape);

}  // namespace markerless_mocap
