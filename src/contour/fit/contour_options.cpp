#include "markerless_mocap/contour/contour_options.h"

#include <stdexcept>
#include <string>

namespace markerless_mocap {

void ContourOptions::visit(OptionVisitor& v) {
  v.field("rays", rays, 100, 20000,
          "number of points on the borders of the silhouettes, over all cameras, that the body is "
          "fitted to");
  v.field("iterations", iterations, 1, 100,
          "damped Gauss-Newton steps per frame at 15 Hz and less; down to half of them at higher "
          "rates");
  v.field("ray_sigma", ray_sigma, 0.001, 0.1,
          "standard deviation of the distance between viewing ray and body, m");
  v.field("effective_rays", effective_rays, 1, 1e5,
          "number of independent rays that all rays together count as");
  v.field("containment_weight", containment_weight, 0, 10,
          "weight of one sphere of the body that leaves one silhouette, in rays");
  v.field("robust_scale_initial", robust_scale_initial, 0.01, 1,
          "distance of a ray from the body above which it has little weight, in the first step, m");
  v.field("robust_scale_final", robust_scale_final, 0.01, 1,
          "the same distance in the last step, m; at most robust_scale_initial");
  v.field("joint_velocity_sigma", joint_velocity_sigma, 0.1, 100,
          "standard deviation of the velocity of a joint about its prediction, rad/s");
  v.field("root_velocity_sigma", root_velocity_sigma, 0.1, 100,
          "standard deviation of the velocity of the body about its prediction, m/s");
}

void ContourOptions::validate() const {
  checkFields(*this);
  if (robust_scale_final > robust_scale_initial)
    throw std::invalid_argument(std::string(kStage) + "/robust_scale_final is " +
                                std::to_string(robust_scale_final) +
                                ", allowed is at most robust_scale_initial, which is " +
                                std::to_string(robust_scale_initial));
}

}  // namespace markerless_mocap
