#include "formats/parts/yaml_parts.h"

#include "files/yaml_map.h"
#include "formats/parts/camera_parts.h"

namespace markerless_mocap {

std::optional<YAML::Node> yamlMap(const std::string& text) {
  constexpr size_t kLongest = 4u << 20;  // a calibration is shorter
  if (text.size() > kLongest || text.rfind("%YAML", 0) == 0 || text.find(':') == std::string::npos)
    return std::nullopt;
  try {
    const YAML::Node root = YAML::Load(text);
    if (root.IsMap()) return root;
  } catch (const YAML::Exception&) {
    // Another kind of file.
  }
  return std::nullopt;
}

YAML::Node yamlRequired(const YAML::Node& map, const char* key, const std::string& where) {
  if (!map.IsMap()) throwFormatError(where, "this is no map of keys to values");
  const YAML::Node value = map[key];
  if (!value) throwFormatError(where, std::string("key '") + key + "' is missing");
  return value;
}

std::vector<double> yamlNumbers(const YAML::Node& node, const std::string& key,
                                const std::string& where) {
  if (!node.IsSequence()) throwFormatError(where, "'" + key + "' is no list of numbers");
  std::vector<double> values;
  for (const YAML::Node& entry : node) {
    if (entry.IsSequence())
      for (const double value : yamlNumbers(entry, key, where)) values.push_back(value);
    else
      values.push_back(finiteYamlNumber(entry, key, where));
  }
  return values;
}

int yamlPixels(const YAML::Node& node, const std::string& key, const std::string& where) {
  return pixelsFrom(finiteYamlNumber(node, key, where), key, where);
}

std::string yamlQuoted(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

}  // namespace markerless_mocap
