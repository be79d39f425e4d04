#include "tools/common/studio_settings.h"

#include <stdexcept>

#include "files/yaml_text.h"
#include "ros/package_files.h"

namespace markerless_mocap {
namespace {

YAML::Node sectionOf(const std::string& config) {
  if (config.empty()) return YAML::Node(YAML::NodeType::Map);
  const YAML::Node root = yamlFrom(readText(config), config);
  if (!root.IsMap() || !root[StudioOptions::kStage])
    throw std::invalid_argument(config + " has no section " + StudioOptions::kStage);
  return root[StudioOptions::kStage];
}

}  // namespace

Overrides parseOverrides(const std::vector<std::string>& texts, const std::string& option) {
  Overrides overrides;
  for (const std::string& text : texts) {
    const size_t sign = text.find('=');
    if (sign == std::string::npos || sign == 0)
      throw std::invalid_argument(option + " is given \"" + text + "\", allowed is KEY=VALUE");
    overrides.emplace_back(text.substr(0, sign), text.substr(sign + 1));
  }
  return overrides;
}

StudioOptions readStudioOptions(const std::string& config, const Overrides& overrides) {
  YAML::Node section = YAML::Clone(sectionOf(config));
  for (const auto& [key, value] : overrides) {
    try {
      section[key] = YAML::Load(value);
    } catch (const YAML::Exception&) {
      throw std::invalid_argument(key + " is \"" + value +
                                  "\", allowed are values as in a configuration file");
    }
  }
  return loadOptions<StudioOptions>(section);
}

}  // namespace markerless_mocap
