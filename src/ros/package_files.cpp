#include "ros/package_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <ros/package.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "files/text_file.h"
#include "markerless_mocap/tracking/shape_file.h"

namespace markerless_mocap {

std::string packageFile(const std::string& relative_path) {
  const std::string package = ros::package::getPath("markerless_mocap");
  if (package.empty())
    throw std::runtime_error(
        "ROS does not find the package markerless_mocap: source the setup.sh of its workspace");
  return package + "/" + relative_path;
}

std::string readText(const std::string& path) {
  return readTextFile(path, path);
}

void writeText(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

PersonResources readPersonResources(const std::string& body_id, const std::string& urdf_template,
                                    const std::string& body_file) {
  PersonResources resources = PersonResources::standard();
  resources.body_id = body_id;
  if (!urdf_template.empty()) resources.urdf_template = readText(urdf_template);
  if (!body_file.empty()) resources.known_shape = shapeFromYaml(readText(body_file), body_file);
  return resources;
}

void writeBodyFile(const std::string& path, const ShapeParameters& shape) {
  const std::string unfinished = path + ".part";
  std::remove(unfinished.c_str());  // or it would keep its permissions
  const int made = open(unfinished.c_str(), O_CREAT | O_EXCL | O_WRONLY, S_IRUSR | S_IWUSR);
  if (made >= 0) close(made);
  std::ofstream file(unfinished);
  file << shapeToYaml(shape);
  file.close();
  if (made < 0 || !file || std::rename(unfinished.c_str(), path.c_str()) != 0)
    throw std::runtime_error("cannot write the body file " + path);
}

}  // namespace markerless_mocap
