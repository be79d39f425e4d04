#pragma once

#include <optional>
#include <string>

#include "markerless_mocap/tracking/shape_parameters.h"

namespace markerless_mocap {

/// What is known about the person before the first frame.
struct PersonResources {
  std::string body_id = "person1";
  std::string urdf_template;                                       ///< text of urdf/human.urdf.in
  ShapeStatistics shape_statistics = ShapeStatistics::handMade();  ///< prior of the body shape
  std::optional<ShapeParameters> known_shape;  ///< shape of this person from an earlier run
  /// If true, the shape is estimated in a thread of its own; if false, update() waits for it.
  bool in_background = false;

  /// The URDF template and the learned body shape (models/contour_body.yaml) of this package.
  static PersonResources standard();
};

}  // namespace markerless_mocap
