#pragma once

#include <optional>
#include <string>

#include "markerless_mocap/tracking/contour_sizes.h"

namespace markerless_mocap {

/// What is known of the person before anything is seen.
struct PersonSources {
  std::string body_id = "person1";
  std::string urdf_template;                             ///< text of urdf/human.urdf.in
  ContourTemplate people = ContourTemplate::handMade();  ///< what bodies look like
  std::optional<ContourSizes> measured;  ///< sizes of this person from an earlier run
  bool in_background = false;  ///< the body is measured while instants go on; else update() waits

  /// The package's own URDF template and its learned body (models/contour_body.yaml).
  static PersonSources standard();
};

}  // namespace markerless_mocap
