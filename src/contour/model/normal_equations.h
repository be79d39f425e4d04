#pragma once

#include <Eigen/Core>
#include <array>

#include "contour/model/contour_kinematics.h"

namespace markerless_mocap {

/// Gauss-Newton sums of one cone's residuals by its eight unknowns (a, radius a, b, radius b). A
/// residual that depends on the point a + s (b - a) and the radius there has the gradient
/// ((1 - s) u, s u) with u its four derivatives by that point and radius, so all that is needed of
/// many residuals are three 4x4 matrices.
class ConeNormalEquations {
 public:
  ConeNormalEquations() { clear(); }
  void clear();
  /// \param u derivatives of the residual by x, y, z and radius at s
  void add(double s, const double (&u)[4], double residual, double weight) {
    const double t = 1.0 - s;
    const double shares[3] = {weight * t * t, weight * t * s, weight * s * s};
    for (int i = 0, k = 0; i < 4; ++i)
      for (int j = i; j < 4; ++j, ++k) {
        const double product = u[i] * u[j];
        for (int part = 0; part < 3; ++part) products_[part][k] += shares[part] * product;
      }
    for (int i = 0; i < 4; ++i) {
      slope_[i] += weight * residual * t * u[i];
      slope_[4 + i] += weight * residual * s * u[i];
    }
  }
  Eigen::Matrix<double, 8, 8> hessian() const;
  Eigen::Matrix<double, 8, 1> gradient() const;

 private:
  double products_[3][10];
  double slope_[8];
};
using AllConeNormalEquations = std::array<ConeNormalEquations, kContourCones>;

/// Normal equations of the pose.
struct PoseNormalEquations {
  Eigen::Matrix<double, kContourDof, kContourDof> H;
  PoseIncrement g;  ///< gradient of half the weighted sum of squares

  void clear() {
    H.setZero();
    g.setZero();
  }
  /// A residual of few degrees of freedom.
  template <int kCount>
  void add(int first_dof, const Eigen::Matrix<double, kCount, 1>& slope, double residual,
           double weight) {
    H.template block<kCount, kCount>(first_dof, first_dof) += weight * slope * slope.transpose();
    g.template segment<kCount>(first_dof) += weight * residual * slope;
  }
};

/// Carries the cones' sums over to the pose.
void accumulatePoseEquations(const AllConeNormalEquations& sums, const ContourFrames& frames,
                             const ContourWorldCones& cones, PoseNormalEquations& equations);

}  // namespace markerless_mocap
