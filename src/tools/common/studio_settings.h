#pragma once

#include <string>
#include <utility>
#include <vector>

#include "capture/studio_options.h"

namespace markerless_mocap {

/// Keys and values of texts KEY=VALUE. Throws std::invalid_argument on other texts.
using Overrides = std::vector<std::pair<std::string, std::string>>;
Overrides parseOverrides(const std::vector<std::string>& texts, const std::string& option);

/// Options of the virtual studio: `overrides` (key and value as in a configuration file) take
/// precedence over the section virtual_studio of the file, which takes precedence over the
/// defaults. Throws std::runtime_error or std::invalid_argument if the file or its section is
/// missing, or on unknown keys or invalid values.
/// \param config path, or empty
StudioOptions readStudioOptions(const std::string& config, const Overrides& overrides);

}  // namespace markerless_mocap
