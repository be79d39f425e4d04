#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The rig as the text of a YAML file, with units and frames in comments. docs/conventions.md
/// describes the format. Numbers are written with all their digits, so that reading returns the
/// same values. Rotations are first rounded to 1e-13 rad, and are then reproduced bit by bit as
/// well. Throws std::invalid_argument as readRig() if the rig has no cameras, two cameras of one
/// name, or a camera that is not valid.
std::string rigText(const std::vector<CameraCalibration>& rig);

/// Reads the text that rigText() writes.
/// \param where name of the file, for error messages
/// Throws std::invalid_argument with a message that names the file, the camera, the key and the
/// allowed values: if the text is no YAML or has no cameras, if a key is missing, repeated or
/// unknown, if a value is not a finite number, if a quaternion is not a rotation, or if a name is
/// empty or repeated.
std::vector<CameraCalibration> rigFromText(const std::string& text, const std::string& where);

/// Write and read a rig file; as rigText() and rigFromText(). Both throw std::runtime_error if the
/// file cannot be written or read.
void writeRig(const std::string& path, const std::vector<CameraCalibration>& rig);
std::vector<CameraCalibration> readRig(const std::string& path);

/// The cameras with these names, in the order of `names`. Throws std::invalid_argument with a
/// message that lists the names that are not in the rig and the cameras that are.
std::vector<CameraCalibration> camerasNamed(const std::vector<std::string>& names,
                                            const std::vector<CameraCalibration>& rig,
                                            const std::string& where);

}  // namespace markerless_mocap
