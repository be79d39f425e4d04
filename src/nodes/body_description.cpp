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

BodyDescription::BodyDescription(const FittingNodeOptions& options, double stature)
    : parameter_("/human_description_" + options.body_id), set_here_(!options.urdf_from_parameter) {
  std::string urdf;
  if (set_here_) {
    urdf = fillUrdfTemplate(readUrdfTemplate(options.urdf_template), options.body_id,
                            BodyProportions::fromStature(stature));
  } else if (!ros::param::get(parameter_, urdf)) {
    throw std::invalid_argument("parameter " + parameter_ +
                                " is not set, allowed is the text of a URDF");
  }
  try {
    model_ = std::make_shared<const BodyModel>(BodyModel::fromUrdf(urdf, options.body_id));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("URDF for parameter " + parameter_ + ": " + error.what());
  }
  if (set_here_) ros::param::set(parameter_, urdf);
}

BodyDescription::~BodyDescription() {
  if (set_here_) ros::param::del(parameter_);
}

}  // namespace markerless_mocap
