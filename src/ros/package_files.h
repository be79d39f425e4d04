#pragma once

#include <string>

#include "markerless_mocap/tracking/person_resources.h"

namespace markerless_mocap {

/// Path of a file that belongs to the package, such as "urdf/human.urdf.in". Throws
/// std::runtime_error if ROS does not find the package.
std::string packageFile(const std::string& relative_path);

/// Text of a file. Throws std::runtime_error if it cannot be read.
std::string readText(const std::string& path);
/// Throws std::runtime_error if the file cannot be written.
void writeText(const std::string& path, const std::string& text);

/// What is known of the person. Throws std::runtime_error if a file cannot be read,
/// std::invalid_argument if it does not hold what it should.
/// \param urdf_template empty: the package's own
/// \param body_file sizes of the person, as shapeToYaml() writes them; empty: none
PersonResources readPersonResources(const std::string& body_id, const std::string& urdf_template,
                                    const std::string& body_file);

/// Writes a person's sizes so that the file is there whole or not at all. Throws std::runtime_error
/// if it cannot be written.
void writeBodyFile(const std::string& path, const ShapeParameters& sizes);

}  // namespace markerless_mocap
