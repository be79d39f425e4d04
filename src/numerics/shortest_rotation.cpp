#include "numerics/shortest_rotation.h"

namespace markerless_mocap {

Eigen::Quaterniond shortestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

}  // namespace markerless_mocap
