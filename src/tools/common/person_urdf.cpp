#include "tools/common/person_urdf.h"

#include "markerless_mocap/body/body_urdf.h"
#include "resources/resources.h"
#include "ros/package_files.h"

namespace markerless_mocap {

std::string bodyUrdf(const std::string& template_path, const std::string& id, double stature) {
  const BodyProportions proportions = BodyProportions::fromStature(stature);
  return fillUrdfTemplate(template_path.empty() ? humanUrdfTemplate() : readText(template_path), id,
                          proportions);
}

}  // namespace markerless_mocap
