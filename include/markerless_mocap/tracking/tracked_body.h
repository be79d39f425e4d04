#pragma once

#include <memory>
#include <string>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/tracking/person_resources.h"
#include "markerless_mocap/tracking/shape_parameters.h"

namespace markerless_mocap {

/// The tracked person.
struct TrackedBody {
  std::string urdf;
  std::shared_ptr<const BodyModel> model;
  /// parameters of the contour body, metres
  ShapeParameters shape;
  bool shape_estimated = false;  ///< true: shape of this person; false: mean shape of people of
                                 ///< this stature
};

/// The person before the first frame: the shape of an earlier run, or else the mean shape at the
/// stature. Throws std::invalid_argument if the URDF template describes no body.
std::shared_ptr<const TrackedBody> initialBody(const PersonResources& resources, double stature);

/// The person with a known shape.
std::shared_ptr<const TrackedBody> bodyFromShape(const PersonResources& resources,
                                                 const ShapeParameters& shape);

}  // namespace markerless_mocap
