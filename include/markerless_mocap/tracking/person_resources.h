#pragma once

#include <optional>
#include <string>

#include "markerless_mocap/tracking/shape_parameters.h"

namespace markerless_mocap {

/// What is known of the person before anything is seen.
struct PersonResources {
  std::string body_id = "person1";
  std::string urdf_template;                             ///< text of urdf/human.urdf.in
  ShapeStatistics people = ShapeStatistics::handMade();  ///< what bodies look like
  std::optional<ShapeParameters> measured;  ///< sizes of this person from an earlier run
  bool in_background = false;  ///< the body is measured while instants go on; else update() waits

  /// The package's own URDF template and its learned body (models/contour_body.yaml).
  static PersonResources standard();
};

}  // namespace markerless_mocap
