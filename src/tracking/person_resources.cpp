#include "markerless_mocap/tracking/person_resources.h"

#include "resources/resources.h"

namespace markerless_mocap {

PersonResources PersonResources::standard() {
  PersonResources resources;
  resources.urdf_template = humanUrdfTemplate();
  resources.shape_statistics =
      ShapeStatistics::fromYaml(contourBodyYaml(), "models/contour_body.yaml");
  return resources;
}

}  // namespace markerless_mocap
