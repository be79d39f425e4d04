#include "tools/common/person_urdf.h"

#include <stdexcept>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/body/body_urdf.h"
#include "resources/resources.h"
#include "ros/package_files.h"

namespace markerless_mocap {

std::string bodyUrdf(const std::string& template_path, const std::string& id, double stature) {
  const BodyProportions proportions = BodyProportions::fromStature(stature);
  if (template_path.empty()) return fillUrdfTemplate(humanUrdfTemplate(), id, proportions);
  const std::string text = readText(template_path);
  try {
    const std::string urdf = fillUrdfTemplate(text, id, proportions);
    BodyModel::fromUrdf(urdf, id);  // refuses what is no body
    return urdf;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(template_path + ": " + error.what());
  }
}

}  // namespace markerless_mocap
