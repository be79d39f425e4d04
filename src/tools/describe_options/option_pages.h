#pragma once

#include <string>

namespace markerless_mocap {

/// docs/parameters.md: every option of every stage and of the virtual studio, one table each.
std::string parameterPage();

/// config/default.yaml: every option of every stage with its default, its meaning as a comment.
std::string defaultConfiguration();

}  // namespace markerless_mocap
