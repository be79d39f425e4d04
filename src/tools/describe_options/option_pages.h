#pragma once

#include <string>

namespace markerless_mocap {

/// docs/parameters.md: every option of every stage and of the virtual studio, a table per section.
std::string parameterPage();

/// config/all_options.yaml: every option of every stage with its default, its meaning as a comment.
std::string allOptionsPage();

}  // namespace markerless_mocap
