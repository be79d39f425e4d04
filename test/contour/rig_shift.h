#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

inline const Eigen::Vector3d kMiddle(0, 0, 0.95);

/// By how much the images of the middle differ, two rows per camera, pixels.
inline Eigen::VectorXd shiftBetween(const CameraRig& from, const CameraRig& to) {
  Eigen::VectorXd shift(2 * from.size());
  for (size_t i = 0; i < from.size(); ++i)
    shift.segment<2>(Eigen::Index(2 * i)) = *to[i].project(kMiddle) - *from[i].project(kMiddle);
  return shift;
}

/// What is left of shifts when the body may be elsewhere, which no contour can tell.
inline Eigen::VectorXd relative(const CameraRig& rig, const Eigen::VectorXd& shifts) {
  Eigen::MatrixXd moves(shifts.size(), 3);
  for (int k = 0; k < 3; ++k)
    for (size_t i = 0; i < rig.size(); ++i)
      moves.col(k).segment<2>(Eigen::Index(2 * i)) =
          1e3 *
          (*rig[i].project(kMiddle + 1e-3 * Eigen::Vector3d::Unit(k)) - *rig[i].project(kMiddle));
  return shifts - moves * moves.colPivHouseholderQr().solve(shifts);
}

}  // namespace markerless_mocap
