#pragma once

#include <string>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// The volume as a configuration file: a section visual_hull with volume, volume_min, volume_max.
std::string volumeText(const HullOptions& options);

/// The options with the volume of such a file. Throws std::runtime_error if it cannot be read,
/// std::invalid_argument with the file's name if it holds anything else.
HullOptions withVolumeOf(const std::string& file, const HullOptions& options);

}  // namespace markerless_mocap
