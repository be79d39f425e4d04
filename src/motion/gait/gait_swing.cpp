#include "motion/gait/gait_swing.h"

#include <cmath>

namespace markerless_mocap {

double minimumJerk(double u) {
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

double swingBump(double u) {
  return 16.0 * u * u * (1.0 - u) * (1.0 - u);
}

GroundPose swingPose(const GroundPose& from, const GroundPose& to, const Eigen::Vector2d& detour,
                     double u) {
  const double progress = minimumJerk(u);
  const double round =
      64.0 * std::pow(u * (1.0 - u), 3);  // starts slowly, when the foot is off the floor
  GroundPose place;
  place.position = (1.0 - progress) * from.position + progress * to.position + round * detour;
  place.heading = (1.0 - progress) * from.heading + progress * to.heading;
  return place;
}

}  // namespace markerless_mocap
