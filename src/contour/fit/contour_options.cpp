#include "markerless_mocap/contour/contour_options.h"

#include <stdexcept>

namespace markerless_mocap {

void ContourOptions::visit(OptionVisitor& v) {
  v.field("rays", rays, 100, 20000,
          "points on the silhouettes' borders, over all cameras, that a body is fitted to");
  v.field("iterations", iterations, 1, 100, "Levenberg-Marquardt steps per instant");
  v.field("sigma", sigma, 0.001, 0.1,
          "standard deviation of the distance between viewing ray and body, m");
  v.field("effective_rays", effective_rays, 1, 1e5,
          "independent rays that all rays together count for");
  v.field("containment_weight", containment_weight, 0, 10,
          "what one ball of the body that leaves one silhouette counts for, in rays");
  v.field("robust_scale_initial", robust_scale_initial, 0.01, 1,
          "distance from which on a ray is mostly ignored, first step, m");
  v.field("robust_scale_final", robust_scale_final, 0.01, 1, "the same in the last step, m");
  v.field("joint_velocity_sigma", joint_velocity_sigma, 0.1, 100,
          "standard deviation of what a joint turns other than predicted, rad/s");
  v.field("root_velocity_sigma", root_velocity_sigma, 0.1, 100,
          "standard deviation of what the body moves other than predicted, m/s");
}

void ContourOptions::validate() const {
  checkFields(*this);
  if (robust_scale_final > robust_scale_initial)
    throw std::invalid_argument(
        "contour_fitting: robust_scale_final must not be greater than robust_scale_initial");
}

}  // namespace markerless_mocap
