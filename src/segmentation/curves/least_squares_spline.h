#pragma once

#include <Eigen/Core>

namespace markerless_mocap {

/// Cubic B-spline h(s), s in [0, 1], of any dimension with evenly spaced knots, that minimises
/// sum_i w_i |v_i - h(s_i)|^2 (Hsiao 2008, Eq. 3-8 and 3-16).
class LeastSquaresSpline {
 public:
  /// \param sites s_i; values outside [0, 1] count as the nearer end
  /// \param values v_i, one row per site
  /// \param weights w_i > 0
  /// \param pieces polynomial pieces, >= 1
  /// Where sites leave a piece undetermined, the smoothest continuation is taken.
  LeastSquaresSpline(const Eigen::VectorXd& sites, const Eigen::MatrixXd& values,
                     const Eigen::VectorXd& weights, int pieces);

  /// All weights 1.
  LeastSquaresSpline(const Eigen::VectorXd& sites, const Eigen::MatrixXd& values, int pieces)
      : LeastSquaresSpline(sites, values, Eigen::VectorXd::Ones(sites.size()), pieces) {}

  Eigen::VectorXd at(double s) const;

 private:
  int pieces_;
  Eigen::MatrixXd controls_;  ///< pieces + 3 rows
};

}  // namespace markerless_mocap
