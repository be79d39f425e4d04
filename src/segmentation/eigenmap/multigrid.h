#pragma once

#include <Eigen/Core>
#include <vector>

#include "segmentation/eigenmap/block_kernels.h"
#include "segmentation/eigenmap/graph_hierarchy.h"

namespace markerless_mocap {

/// Approximate inverse of the Laplacian on each level of a hierarchy: one symmetric V-cycle.
class Multigrid {
 public:
  /// \param coarsest_values, coarsest_vectors all pairs L u = lambda M u of the coarsest level,
  ///   u' M u = 1, ascending
  Multigrid(const std::vector<GraphLevel>& levels, const Eigen::VectorXd& coarsest_values,
            const Eigen::MatrixXd& coarsest_vectors, int width);

  /// x ~ L^-1 b on a level; the columns of b sum to zero.
  void solve(size_t level, const Block& b, Block* x);

 private:
  void solveCoarsest(const Block& b, Block* x) const;

  const std::vector<GraphLevel>& levels_;
  Eigen::MatrixXf inverse_;                     ///< pseudo-inverse on the coarsest level
  std::vector<Block> right_, solution_, work_;  ///< scratch memory of each level
};

}  // namespace markerless_mocap
