#pragma once

#include <string>

#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// Reads a configuration file. Throws std::runtime_error if it cannot be read,
/// std::invalid_argument if it is no YAML or as loadPipelineOptions(). The message names the file.
PipelineOptions readConfiguration(const std::string& path);

}  // namespace markerless_mocap
