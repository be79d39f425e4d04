#pragma once

#include <memory>
#include <string>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/tracking/person_resources.h"
#include "markerless_mocap/tracking/shape_parameters.h"

namespace markerless_mocap {

/// The person that is followed.
struct TrackedBody {
  std::string urdf;
  std::shared_ptr<const BodyModel> model;
  /// Of the body that contours are fitted with.
  ShapeParameters sizes;
  bool measured = false;  ///< sizes are this person's, else those of people of the stature
};

/// The person as far as known before anything is seen. Throws std::invalid_argument as
/// makeBodyTracker().
std::shared_ptr<const TrackedBody> initialBody(const PersonResources& sources, double stature);

/// The person of measured sizes.
std::shared_ptr<const TrackedBody> bodyFromShape(const PersonResources& sources,
                                                 const ShapeParameters& sizes);

}  // namespace markerless_mocap
