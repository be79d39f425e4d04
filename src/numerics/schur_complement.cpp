#include "numerics/schur_complement.h"

#include <Eigen/Cholesky>
#include <utility>

namespace markerless_mocap {

ReducedNormalEquations::ReducedNormalEquations(PartedNormalEquations parts)
    : H_(std::move(parts.H)), g_(std::move(parts.g)) {
  const Eigen::LLT<Eigen::MatrixXd> inner(parts.inner_H);
  back_ = inner.solve(parts.mixed);
  at_rest_ = -inner.solve(parts.inner_g);
  H_.noalias() -= parts.mixed.transpose() * back_;
  g_.noalias() += parts.mixed.transpose() * at_rest_;
}

}  // namespace markerless_mocap
