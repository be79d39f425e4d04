#include "ros/package_files.h"

#include <ros/package.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "files/text_file.h"
#include "files/whole_file.h"
#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/body/body_urdf.h"
#include "markerless_mocap/tracking/shape_file.h"

namespace markerless_mocap {

std::string packageFile(const std::string& relative_path) {
  const std::string package = ros::package::getPath("markerless_mocap");
  if (package.empty())
    throw std::runtime_error(
        "ROS does not find the package markerless_mocap: source the setup.sh of its workspace");
  return package + "/" + relative_path;
}

bool isThere(const std::string& path) {
  std::error_code ignored;
  return !path.empty() && std::filesystem::exists(path, ignored);
}

std::string readText(const std::string& path) {
  return readTextFile(path, path);
}

void writeText(const std::string& path, const std::string& text) {
  writeWholeFile(path, text);
}

std::string readUrdfTemplate(const std::string& path, const std::string& body_id) {
  constexpr double kAnyStature = 1.75;  // metres
  std::string text = readText(path);
  try {
    BodyModel::fromUrdf(fillUrdfTemplate(text, body_id, BodyProportions::fromStature(kAnyStature)),
                        body_id);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
  return text;
}

PersonResources readPersonResources(const std::string& body_id, const std::string& urdf_template,
                                    const std::string& body_file) {
  PersonResources resources = PersonResources::standard();
  resources.body_id = body_id;
  if (!urdf_template.empty()) resources.urdf_template = readUrdfTemplate(urdf_template, body_id);
  if (!body_file.empty()) resources.known_shape = shapeFromYaml(readText(body_file), body_file);
  return resources;
}

void writeBodyFile(const std::string& path, const ShapeParameters& shape) {
  writeWholeFileBy(path, [&](const std::string& active) {
    namespace fs = std::filesystem;
    std::error_code error;  // before there is anything to read in it
    fs::permissions(active, fs::perms::owner_read | fs::perms::owner_write, error);
    std::ofstream file(active);
    file << shapeToYaml(shape);
    file.close();
    return !error && file;
  });
}

}  // namespace markerless_mocap
