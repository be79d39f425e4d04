#include "segmentation/eigenmap/lobpcg.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace markerless_mocap {
namespace {

/// A unit vector of a basis must keep at least this squared norm after projection on the complement
/// of the vectors before it. Smaller norms are below the precision of the products.
constexpr double kMinIndependent = 1e-5;

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Combination = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct RitzPairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;  ///< orthonormal under the mass products
};

/// The pairs of a basis with the smallest values, computed from its products; empty if the basis is
/// nearly linearly dependent.
std::optional<RitzPairs> lowestPairs(const Eigen::MatrixXd& laplacian, const Eigen::MatrixXd& mass,
                                     Eigen::Index count) {
  if (mass.diagonal().minCoeff() <= 0.0) return {};
  const Eigen::VectorXd scale = mass.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> root(scale.asDiagonal() * mass * scale.asDiagonal());
  if (root.info() != Eigen::Success) return {};
  if (root.matrixLLT().diagonal().cwiseAbs2().minCoeff() < kMinIndependent) return {};
  Eigen::MatrixXd reduced = scale.asDiagonal() * laplacian * scale.asDiagonal();
  root.matrixL().solveInPlace(reduced);
  root.matrixU().solveInPlace<Eigen::OnTheRight>(reduced);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(reduced);
  Eigen::MatrixXd vectors = solver.eigenvectors().leftCols(count);
  root.matrixU().solveInPlace(vectors);
  return RitzPairs{solver.eigenvalues().head(count), scale.asDiagonal() * vectors};
}

}  // namespace

Lobpcg::Lobpcg(const GraphLevel& level, size_t level_number, Multigrid* multigrid, Block start)
    : level_(level),
      number_(level_number),
      multigrid_(*multigrid),
      x_(std::move(start)),
      rest_(x_.nodes, x_.width),
      w_(x_.nodes, x_.width),
      lw_(x_.nodes, x_.width),
      p_(x_.nodes, x_.width) {}

bool Lobpcg::run(int modes, double tolerance, int max_steps) {
  if (!orthonormalize()) return false;
  for (int step = 0;; ++step) {
    measure();
    if (residuals_.head(modes).maxCoeff() <= tolerance) return true;
    if (step == max_steps || !improve()) return false;
  }
}

bool Lobpcg::orthonormalize() {
  removeMean(level_, &x_);
  multiply(level_, x_, &lw_);
  Square laplacian(x_.width, x_.width);
  Square mass(x_.width, x_.width);
  products(level_, x_, lw_, {{&x_, laplacian.data(), mass.data()}});
  const auto pairs = lowestPairs(laplacian, mass, x_.width);
  if (!pairs) return false;
  values_ = pairs->values;
  const Combination combination = pairs->vectors.cast<float>();
  combine(combination.data(), &x_);
  has_step_ = false;
  return true;
}

/// Computes values and residuals; stores the residual vectors in rest_.
void Lobpcg::measure() {
  const Eigen::VectorXf factors = values_.cast<float>();
  Eigen::VectorXd squares(x_.width);
  markerless_mocap::residuals(level_, factors.data(), x_, &rest_, squares.data());
  residuals_ = squares.cwiseSqrt().cwiseQuotient(values_);
}

bool Lobpcg::improve() {
  multigrid_.solve(number_, rest_, &w_);
  removeMean(level_, &w_);
  multiply(level_, w_, &lw_);
  Gram gram = gramOfBasis();
  auto pairs = lowestPairs(gram.laplacian, gram.mass, x_.width);
  if (!pairs && has_step_) {
    has_step_ = false;
    gram = gramOfBasis();
    pairs = lowestPairs(gram.laplacian, gram.mass, x_.width);
  }
  if (!pairs) return false;
  values_ = pairs->values;
  takeStep(pairs->vectors);
  keepProductsOfStep(gram, pairs->vectors);
  return true;
}

Lobpcg::Gram Lobpcg::gramOfBasis() const {
  const Eigen::Index width = x_.width;
  const Eigen::Index all = (has_step_ ? 3 : 2) * width;
  Gram gram{Eigen::MatrixXd::Zero(all, all), Eigen::MatrixXd::Zero(all, all)};
  const auto set = [&](Eigen::MatrixXd* matrix, int i, int j, const Eigen::MatrixXd& block) {
    matrix->block(i * width, j * width, width, width) = block;
    matrix->block(j * width, i * width, width, width) = block.transpose();
  };
  std::array<Square, 3> laplacian;
  std::array<Square, 3> mass;
  const std::array<const Block*, 3> basis{&x_, &w_, &p_};
  std::vector<Product> wanted;
  for (int j = 0; j < all / width; ++j) {
    laplacian[j].resize(width, width);
    mass[j].resize(width, width);
    wanted.push_back({basis[j], laplacian[j].data(), mass[j].data()});
  }
  products(level_, w_, lw_, wanted);
  for (int j = 0; j < all / width; ++j) {
    set(&gram.laplacian, 1, j, laplacian[j]);
    set(&gram.mass, 1, j, mass[j]);
  }
  gram.laplacian.topLeftCorner(width, width) = values_.asDiagonal();
  gram.mass.topLeftCorner(width, width).setIdentity();
  if (!has_step_) return gram;
  set(&gram.laplacian, 2, 0, step_x_.laplacian);
  set(&gram.mass, 2, 0, step_x_.mass);
  set(&gram.laplacian, 2, 2, step_.laplacian);
  set(&gram.mass, 2, 2, step_.mass);
  return gram;
}

void Lobpcg::takeStep(const Eigen::MatrixXd& vectors) {
  const int width = x_.width;
  const Combination of_x = vectors.topRows(width).cast<float>();
  const Combination of_w = vectors.middleRows(width, width).cast<float>();
  const Combination of_p = vectors.bottomRows(width).cast<float>();
  markerless_mocap::takeStep(w_, {of_x.data(), of_w.data(), has_step_ ? of_p.data() : nullptr}, &x_,
                             &p_);
  has_step_ = true;
}

/// The products of the new step follow from those of the basis, as the step is a combination of it.
void Lobpcg::keepProductsOfStep(const Gram& gram, const Eigen::MatrixXd& vectors) {
  Eigen::MatrixXd step = vectors;
  step.topRows(x_.width).setZero();
  const Eigen::MatrixXd laplacian = step.transpose() * gram.laplacian;
  const Eigen::MatrixXd mass = step.transpose() * gram.mass;
  step_ = {laplacian * step, mass * step};
  step_x_ = {laplacian * vectors, mass * vectors};
}

}  // namespace markerless_mocap
