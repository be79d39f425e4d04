#include "markerless_mocap/tracking/person_sources.h"

#include "resources/resources.h"

namespace markerless_mocap {

PersonSources PersonSources::standard() {
  PersonSources sources;
  sources.urdf_template = humanUrdfTemplate();
  sources.people = ContourTemplate::fromText(contourBodyYaml(), "models/contour_body.yaml");
  return sources;
}

}  // namespace markerless_mocap
