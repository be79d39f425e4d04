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
  /// Shape parameters of the contour body, metres.
  ShapeParameters shape;
  /// True if the shape is this person's own; false if it is the mean shape at a stature.
  bool shape_estimated = false;
};

/// The person before the first frame: the shape of an earlier run, or else the mean shape at the
/// stature. Throws std::invalid_argument if the URDF template describes no body.
std::shared_ptr<const TrackedBody> initialBody(const PersonResources& resources, double stature);

/// The person with a known shape.
std::shared_ptr<const TrackedBody> bodyFromShape(const PersonResources& resources,
                                                 const ShapeParameters& shape);

}  // namespace markerless_mocap
