#include "nodes/body_description.h"

#include <ros/package.h>
#include <ros/param.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {

std::string readUrdfTemplate(const std::string& file) {
  const std::string path =
      file.empty() ? ros::package::getPath("markerless_mocap") + "/urdf/human.urdf.in" : file;
  std::ifstream in(path);
  if (!in) throw std::invalid_argument("the URDF template " + path + " cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

BodyDescription::BodyDescription(const std::string& id, const std::string& template_file,
                                 double stature)
    : parameter_("/human_description_" + id) {
  std::string urdf;
  const bool given = ros::param::get(parameter_, urdf);
  if (!given)
    urdf = fillUrdfTemplate(readUrdfTemplate(template_file), id,
                            BodyProportions::fromStature(stature));
  try {
    model_ = std::make_shared<const BodyModel>(BodyModel::fromUrdf(urdf, id));
  } catch (const std::invalid_argument& error) {
    if (!given) throw;
    throw std::invalid_argument("parameter " + parameter_ + ": " + error.what());
  }
  if (!given) ros::param::set(parameter_, urdf);
  set_here_ = !given;
}

BodyDescription::~BodyDescription() {
  if (set_here_) ros::param::del(parameter_);
}

}  // namespace markerless_mocap
