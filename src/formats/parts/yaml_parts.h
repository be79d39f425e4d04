#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

namespace markerless_mocap {

/// The first document of a text; empty if the text is no YAML map, or is OpenCV's dialect.
std::optional<YAML::Node> yamlMap(const std::string& text);

/// Value of a key; throws std::invalid_argument if it is missing.
YAML::Node yamlRequired(const YAML::Node& map, const char* key, const std::string& where);
/// A list of numbers, or a list of lists row by row.
std::vector<double> yamlNumbers(const YAML::Node& node, const std::string& key,
                                const std::string& where);
/// A number of pixels, 1 to 65536.
int yamlPixels(const YAML::Node& node, const std::string& key, const std::string& where);
/// A text between double quotes with what YAML needs escaped.
std::string yamlQuoted(const std::string& text);

}  // namespace markerless_mocap
