#pragma once

#include <ceres/sized_cost_function.h>

#include "calibration/adjust/residuals.h"

namespace markerless_mocap {

/// CornerResidual with derivatives by hand; blocks: intrinsics, camera_world, world_board, offset.
class CornerCost : public ceres::SizedCostFunction<2, 12, 6, 6, 1> {
 public:
  explicit CornerCost(const CornerResidual& corner) : corner_(corner) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  CornerResidual corner_;
};

/// Derivatives of a pixel with respect to the point in the camera's frame and to the intrinsics.
struct PixelSlopes {
  Eigen::Matrix<double, 2, 3> point;
  Eigen::Matrix<double, 2, 12> intrinsics;
};

PixelSlopes pixelSlopes(LensType lens, const double* intrinsics, const Eigen::Vector3d& point);

/// The matrix of the cross product v x.
Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v);

}  // namespace markerless_mocap
