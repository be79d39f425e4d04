#pragma once

#include <Eigen/Core>

namespace markerless_mocap {

/// Cubic B-spline h(s), s in [0, 1], of any dimension with evenly spaced knots, that minimises
/// sum_i w_i |v_i - h(s_i)|^2 (Hsiao 2008, Eq. 3-8 and 3-16).
class LeastSquaresSpline {
 public:
  /// \param sites s_i; values outside [0, 1] are clamped
  /// \param values v_i, one row per site
  /// \param weights w_i > 0
  /// \param pieces number of polynomial pieces, >= 1
  /// If the sites do not determine a piece, the smoothest continuation is used.
  LeastSquaresSpline(const Eigen::VectorXd& sites, const Eigen::MatrixXd& values,
                     const Eigen::VectorXd& weights, int pieces);

  /// The same with all weights 1.
  LeastSquaresSpline(const Eigen::VectorXd& sites, const Eigen::MatrixXd& values, int pieces)
      : LeastSquaresSpline(sites, values, Eigen::VectorXd::Ones(sites.size()), pieces) {}

  Eigen::VectorXd at(double s) const;

 private:
  int pieces_;
  Eigen::MatrixXd controls_;  ///< pieces + 3 rows
};

}  // namespace markerless_mocap
