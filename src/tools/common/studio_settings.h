#pragma once

#include <string>
#include <utility>
#include <vector>

#include "capture/studio_options.h"

namespace markerless_mocap {

/// Keys and values of texts KEY=VALUE. Throws std::invalid_argument on others.
using Overrides = std::vector<std::pair<std::string, std::string>>;
Overrides parseOverrides(const std::vector<std::string>& texts, const std::string& option);

/// The section virtual_studio of a configuration file, then `changes` (key and value as they would
/// stand there), then the defaults. Throws std::runtime_error or std::invalid_argument with one
/// sentence: no such file, no such section, unknown keys, bad values.
/// \param config path, or empty
StudioOptions readStudioOptions(const std::string& config, const Overrides& overrides);

}  // namespace markerless_mocap
