#pragma once

#include <Eigen/Core>

#include "segmentation/eigenmap/block_kernels.h"
#include "segmentation/eigenmap/graph_hierarchy.h"
#include "segmentation/eigenmap/multigrid.h"

namespace markerless_mocap {

/// The locally optimal block preconditioned conjugate gradient method (Knyazev 2001) for L u =
/// lambda M u on one level of a hierarchy. Each step takes the best combinations of the vectors, of
/// their residuals preconditioned by a multigrid cycle, and of the previous step.
class Lobpcg {
 public:
  /// \param start linearly independent functions; their constant part is removed
  Lobpcg(const GraphLevel& level, size_t level_number, Multigrid* multigrid, Block start);

  /// Iterates until the residuals of the first `modes` modes are at most `tolerance`, up to
  /// `max_steps` times.
  /// \return whether the tolerance was reached
  bool run(int modes, double tolerance, int max_steps);

  const Block& vectors() const { return x_; }                      ///< x' M x = 1
  const Eigen::VectorXd& values() const { return values_; }        ///< ascending
  const Eigen::VectorXd& residuals() const { return residuals_; }  ///< as in GraphModes

 private:
  /// Products of the basis [x w p], or [x w], under L and M.
  struct Gram {
    Eigen::MatrixXd laplacian;
    Eigen::MatrixXd mass;
  };

  bool orthonormalize();
  void measure();
  bool improve();
  Gram gramOfBasis() const;
  void takeStep(const Eigen::MatrixXd& vectors);
  void keepProductsOfStep(const Gram& gram, const Eigen::MatrixXd& vectors);

  const GraphLevel& level_;
  size_t number_;
  Multigrid& multigrid_;
  Block x_, rest_;
  Block w_, lw_;  ///< preconditioned residuals
  Block p_;       ///< last step
  bool has_step_ = false;
  Eigen::VectorXd values_, residuals_;
  Gram step_, step_x_;  ///< products p' p and p' x
};

}  // namespace markerless_mocap
