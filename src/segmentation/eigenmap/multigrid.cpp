#include "segmentation/eigenmap/multigrid.h"

namespace markerless_mocap {
namespace {

/// Damping of the two Jacobi sweeps before and, in reverse order, after the coarse correction:
/// inverse roots of the Chebyshev polynomial of degree 2 on [0.5, 2], the range of the eigenvalues
/// of rough functions.
constexpr float kDamping[] = {0.56f, 1.39f};
constexpr float kOvercorrection = 1.7f;  // piecewise constant functions are too stiff

using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

Multigrid::Multigrid(const std::vector<GraphLevel>& levels, const Eigen::VectorXd& coarsest_values,
                     const Eigen::MatrixXd& coarsest_vectors, int width)
    : levels_(levels) {
  const Eigen::Index rest = coarsest_values.size() - 1;  // the first pair is the constant function
  inverse_ =
      (coarsest_vectors.rightCols(rest) * coarsest_values.tail(rest).cwiseInverse().asDiagonal() *
       coarsest_vectors.rightCols(rest).transpose())
          .cast<float>();
  for (const GraphLevel& level : levels) {
    const bool finest = right_.empty();
    right_.emplace_back(finest ? 0 : level.nodeCount(), width);
    solution_.emplace_back(finest ? 0 : level.nodeCount(), width);
    work_.emplace_back(level.nodeCount(), width);
  }
}

void Multigrid::solveCoarsest(const Block& b, Block* x) const {
  const Eigen::Map<const RowMajor> right(b.values.data(), Eigen::Index(b.nodes), b.width);
  Eigen::Map<RowMajor> solution(x->values.data(), Eigen::Index(x->nodes), x->width);
  solution.noalias() = inverse_ * right;
}

void Multigrid::solve(size_t level, const Block& b, Block* x) {
  if (level + 1 == levels_.size()) {
    solveCoarsest(b, x);
    return;
  }
  const GraphLevel& graph = levels_[level];
  Block* work = &work_[level];
  scaleByDiagonal(graph, kDamping[0], b, work);
  relax(graph, kDamping[1], b, *work, x);
  restrictResidual(graph, b, *x, &right_[level + 1]);
  solve(level + 1, right_[level + 1], &solution_[level + 1]);
  prolongate(graph, kOvercorrection, solution_[level + 1], x);
  relax(graph, kDamping[1], b, *x, work);
  relax(graph, kDamping[0], b, *work, x);
}

}  // namespace markerless_mocap
