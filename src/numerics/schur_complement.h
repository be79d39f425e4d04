#pragma once

#include <Eigen/Core>

namespace markerless_mocap {

/// Normal equations H step = -g of two groups of unknowns. Of many samples the inner unknowns are
/// each sample's own, and the outer ones common to all.
struct PartedNormalEquations {
  Eigen::MatrixXd inner_H;  ///< inner x inner, positive definite
  Eigen::VectorXd inner_g;
  Eigen::MatrixXd mixed;  ///< inner x outer
  Eigen::MatrixXd H;      ///< outer x outer
  Eigen::VectorXd g;
};

/// The equations of the outer unknowns after the inner ones have been eliminated (Schur
/// complement).
class ReducedNormalEquations {
 public:
  ReducedNormalEquations() = default;
  explicit ReducedNormalEquations(PartedNormalEquations parts);

  const Eigen::MatrixXd& H() const { return H_; }
  const Eigen::VectorXd& g() const { return g_; }
  /// The step of the inner unknowns that belongs to one of the outer ones.
  Eigen::VectorXd innerStep(const Eigen::VectorXd& outer_step) const {
    return at_rest_ - back_ * outer_step;
  }

 private:
  Eigen::MatrixXd H_;
  Eigen::VectorXd g_;
  Eigen::MatrixXd back_;
  Eigen::VectorXd at_rest_;  ///< step of the inner unknowns if the outer ones stay
};

}  // namespace markerless_mocap
