#include "tools/common/configuration.h"

#include <stdexcept>

#include "files/text_file.h"
#include "files/yaml_text.h"

namespace markerless_mocap {

PipelineOptions readConfiguration(const std::string& path) {
  const YAML::Node root = yamlFrom(readTextFile(path, "the configuration " + path), path);
  try {
    return loadPipelineOptions(root);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace markerless_mocap
