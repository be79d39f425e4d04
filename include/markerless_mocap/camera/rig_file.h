#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The rig as the text of a YAML file (docs/conventions.md has the format), its units and frames in
/// comments. Numbers are written so that they read back the same; rotations are rounded to 1e-13
/// rad, after which they too come back bit by bit. Throws std::invalid_argument as readRig() when
/// the rig has no cameras, two of one name or one that is not valid.
std::string rigText(const std::vector<CameraCalibration>& rig);

/// Reads what rigText() writes.
/// \param where name of the file for the sentences
/// Throws std::invalid_argument with one sentence that names file, camera, key and what is allowed:
/// no YAML, no cameras, a key that is missing, doubled or unknown, a value that is no finite
/// number, a quaternion that is no rotation, names that are empty or doubled.
std::vector<CameraCalibration> rigFromText(const std::string& text, const std::string& where);

/// rigText() to and rigFromText() from a file. Both throw std::runtime_error if the file cannot be
/// written or read, else as those.
void writeRig(const std::string& path, const std::vector<CameraCalibration>& rig);
std::vector<CameraCalibration> readRig(const std::string& path);

/// The cameras of these names, in that order. Throws std::invalid_argument with one sentence that
/// names all that the rig lacks and those it has.
std::vector<CameraCalibration> camerasNamed(const std::vector<std::string>& names,
                                            const std::vector<CameraCalibration>& rig,
                                            const std::string& where);

}  // namespace markerless_mocap
