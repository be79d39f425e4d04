#include "markerless_mocap/body/twist.h"

#include <cmath>

namespace markerless_mocap {

Eigen::Isometry3d exponential(const Twist& twist, double angle) {
  const Eigen::Vector3d& w = twist.w;
  const double c = std::cos(angle), s = std::sin(angle), t = 1.0 - c;
  Eigen::Isometry3d motion;
  motion.makeAffine();
  motion.linear() << t * w.x() * w.x() + c, t * w.x() * w.y() - s * w.z(),
      t * w.x() * w.z() + s * w.y(),  //
      t * w.x() * w.y() + s * w.z(), t * w.y() * w.y() + c, t * w.y() * w.z() - s * w.x(),
      t * w.x() * w.z() - s * w.y(), t * w.y() * w.z() + s * w.x(), t * w.z() * w.z() + c;
  const Eigen::Vector3d wv = w.cross(twist.v);
  motion.translation() = wv - motion.linear() * wv;
  return motion;
}

}  // namespace markerless_mocap
