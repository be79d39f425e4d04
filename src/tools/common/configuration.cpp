#include "tools/common/configuration.h"

#include <stdexcept>

#include "ros/package_files.h"

namespace markerless_mocap {

PipelineOptions readConfiguration(const std::string& path) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(path);
  } catch (const YAML::BadFile&) {
    throw std::runtime_error("cannot read the configuration " + path);
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(path + " is not YAML: " + error.what());
  }
  try {
    return loadPipelineOptions(root);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace markerless_mocap
