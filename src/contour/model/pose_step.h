#pragma once

#include "contour/model/contour_pose.h"

namespace markerless_mocap {

/// Damps a Gauss-Newton step of a pose: adds absolute terms in the units of the Hessian's diagonal,
/// 1/m^2 and 1/rad^2. \param H its first unknowns are the pose
template <class Matrix>
void dampPose(Matrix& H) {
  constexpr double kMoveDamping = 100.0, kTurnDamping = 3.0;
  H.diagonal().template head<3>().array() += kMoveDamping;
  H.diagonal().template segment<kContourDof - 3>(3).array() += kTurnDamping;
}

/// The pose after a step, of which each degree of freedom is limited.
inline ContourPose stepped(const ContourPose& pose, const PoseIncrement& step) {
  constexpr double kMaxStep = 0.35;  // rad or metres
  return boxPlus(pose, step.cwiseMax(-kMaxStep).cwiseMin(kMaxStep));
}

}  // namespace markerless_mocap
