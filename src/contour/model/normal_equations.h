#pragma once

#include <Eigen/Core>
#include <array>

#include "contour/model/contour_kinematics.h"

namespace markerless_mocap {

/// Normal equations of the residuals of one cone with respect to its eight unknowns (a, radius a,
/// b, radius b). A residual depends on the point a + s (b - a) and the radius there. Its gradient
/// is ((1 - s) u, s u), where u are its four derivatives with respect to that point and radius.
/// Three 4x4 matrices therefore hold the sums over any number of residuals.
class ConeNormalEquations {
 public:
  ConeNormalEquations() { clear(); }
  void clear();
  void add(const ConeNormalEquations& other);
  /// \param u derivatives of the residual with respect to x, y, z and radius at s
  void add(double s, const double (&u)[4], double residual, double weight) {
    const double t = 1.0 - s;
    const double factors[3] = {weight * t * t, weight * t * s, weight * s * s};
    for (int i = 0, k = 0; i < 4; ++i)
      for (int j = i; j < 4; ++j, ++k) {
        const double product = u[i] * u[j];
        for (int part = 0; part < 3; ++part) products_[part][k] += factors[part] * product;
      }
    for (int i = 0; i < 4; ++i) {
      gradient_[i] += weight * residual * t * u[i];
      gradient_[4 + i] += weight * residual * s * u[i];
    }
  }
  Eigen::Matrix<double, 8, 8> hessian() const;
  Eigen::Matrix<double, 8, 1> gradient() const;

 private:
  double products_[3][10];
  double gradient_[8];
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
  /// Adds a residual that depends on a few consecutive degrees of freedom.
  template <int kCount>
  void add(int first_dof, const Eigen::Matrix<double, kCount, 1>& gradient, double residual,
           double weight) {
    H.template block<kCount, kCount>(first_dof, first_dof) +=
        weight * gradient * gradient.transpose();
    g.template segment<kCount>(first_dof) += weight * residual * gradient;
  }
};

/// Transforms the equations of the cones to those of the pose.
void accumulatePoseEquations(const AllConeNormalEquations& sums, const ContourFrames& frames,
                             const ContourWorldCones& cones, PoseNormalEquations& equations);

}  // namespace markerless_mocap
