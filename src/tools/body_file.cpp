#include "tools/body_file.h"

#include <ros/package.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {

std::string packageFile(const std::string& relative_path) {
  const std::string package = ros::package::getPath("markerless_mocap");
  if (package.empty())
    throw std::runtime_error(
        "ROS does not find the package markerless_mocap: source the setup.sh of its workspace");
  return package + "/" + relative_path;
}

std::string readText(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error("cannot read " + path);
  return text.str();
}

std::string bodyUrdf(const std::string& template_path, const std::string& id, double stature) {
  const std::string path =
      template_path.empty() ? packageFile("urdf/human.urdf.in") : template_path;
  const BodyProportions proportions = BodyProportions::fromStature(stature);
  return fillUrdfTemplate(readText(path), id, proportions);
}

std::shared_ptr<const BodyModel> loadBody(const std::string& template_path, const std::string& id,
                                          double stature) {
  return std::make_shared<const BodyModel>(
      BodyModel::fromUrdf(bodyUrdf(template_path, id, stature), id));
}

}  // namespace markerless_mocap
