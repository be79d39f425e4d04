#include "markerless_mocap/tracking/person_resources.h"

#include "resources/resources.h"

namespace markerless_mocap {

PersonResources PersonResources::standard() {
  PersonResources sources;
  sources.urdf_template = humanUrdfTemplate();
  sources.people = ShapeStatistics::fromYaml(contourBodyYaml(), "models/contour_body.yaml");
  return sources;
}

}  // namespace markerless_mocap
