#pragma once

#include <toml++/toml.h>

#include <string>

namespace markerless_mocap {

/// What somebody has written as TOML. Throws std::invalid_argument with line and reason if it is
/// none. \param where how the sentence names the text, for example its file
toml::table tomlFrom(const std::string& text, const std::string& where);

}  // namespace markerless_mocap
