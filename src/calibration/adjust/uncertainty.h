#pragma once

#include <set>
#include <vector>

#include "calibration/adjust/rig_state.h"

namespace markerless_mocap {

/// Standard deviations of a camera's estimate.
struct CameraUncertainty {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< m, along x y z of the camera
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< rad, about x y z of the camera
  Eigen::Vector2d focal = Eigen::Vector2d::Zero();      ///< pixels, fx fy
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();     ///< pixels, cx cy
  double time_offset = 0.0;                             ///< s
};

/// Standard deviations from the covariance of the adjustment (normal equations without the boards'
/// poses). The scatter of the residuals of whole instants gives their scale, so that errors which a
/// view's corners share count. Known points count by their own noise. Lens coefficients that a
/// model does without count as not known. Without known points the world is free: then positions
/// and directions are relative to the mean of all cameras. \param offsets whether time offsets were
/// estimated
std::vector<CameraUncertainty> uncertaintiesOf(const Board& board, const RigState& state,
                                               const std::set<size_t>& held, bool offsets);

/// Sets view_sigma: how far whole views scatter more than corners that are independent would, at
/// the lenses' axes, on the mean of the cameras that are estimated. Source: Rao and Scott, The
/// analysis of categorical data from complex sample surveys (1981), whose mean design effect it is.
void estimateViewNoise(const Board& board, const std::set<size_t>& held, bool offsets,
                       RigState* state);

/// Sets corner_sigma and point_sigma from the residuals. \return whether their ratio changed, so
/// that an adjustment with points should be repeated
bool estimateNoise(const Board& board, const std::set<size_t>& held, bool offsets, RigState* state);

}  // namespace markerless_mocap
