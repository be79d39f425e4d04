#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace markerless_mocap {

/// What somebody has written as YAML. Throws std::invalid_argument with line and reason if it is
/// none. \param where how the sentence names the text, for example its file
YAML::Node yamlFrom(const std::string& text, const std::string& where);

/// The same of a text of several documents.
std::vector<YAML::Node> yamlDocumentsFrom(const std::string& text, const std::string& where);

/// What a fault of the YAML library means, and in which line, for example of a value that is no
/// number.
std::string sentenceOf(const YAML::Exception& fault);

}  // namespace markerless_mocap
