#include "tools/body_file.h"

#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {

std::string bodyUrdf(const std::string& template_path, const std::string& id, double stature) {
  const std::string path =
      template_path.empty() ? packageFile("urdf/human.urdf.in") : template_path;
  const BodyProportions proportions = BodyProportions::fromStature(stature);
  return fillUrdfTemplate(readText(path), id, proportions);
}

}  // namespace markerless_mocap
