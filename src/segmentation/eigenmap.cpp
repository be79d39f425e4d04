#include "markerless_mocap/segmentation/eigenmap.h"

#include <Spectra/SymEigsShiftSolver.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kShift = 1e-5;      // makes L + shift D positive definite
constexpr double kTolerance = 1e-6;  // relative, of the shifted and inverted eigenvalues
constexpr int kMaxIterations = 300;
constexpr int kLargestDense = 64;  // nodes up to which the dense solver is as fast

Eigen::VectorXd degrees(const WeightedGraph& graph) {
  Eigen::VectorXd degree = Eigen::VectorXd::Zero(Eigen::Index(graph.nodeCount()));
  for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      degree[node] += graph.weight[e];
    }
  }
  return degree;
}

/// Lower triangle of L + shift D.
Eigen::SparseMatrix<double> shiftedLaplacian(const WeightedGraph& graph,
                                             const Eigen::VectorXd& degree, double shift) {
  Eigen::SparseMatrix<double> matrix(degree.size(), degree.size());
  matrix.reserve(Eigen::VectorXi::Constant(degree.size(), 4));
  for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
    matrix.insert(node, node) = degree[node] * (1.0 + shift);
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      if (graph.neighbor[e] > node) matrix.insert(graph.neighbor[e], node) = -graph.weight[e];
    }
  }
  matrix.makeCompressed();
  return matrix;
}

/// x -> (A + shift I)^-1 x for A = D^-1/2 L D^-1/2, which has the wanted lambdas and, times
/// D^1/2, the wanted vectors.
class InverseNormalizedLaplacian {
 public:
  using Scalar = double;

  InverseNormalizedLaplacian(const WeightedGraph& graph, const Eigen::VectorXd& degree)
      : root_degree_(degree.cwiseSqrt()), solver_(shiftedLaplacian(graph, degree, kShift)) {
    if (solver_.info() != Eigen::Success) {
      throw std::runtime_error("laplacianEigenmap: the Laplacian could not be factorised");
    }
  }
  Eigen::Index rows() const { return root_degree_.size(); }
  Eigen::Index cols() const { return root_degree_.size(); }
  void set_shift(double) {}  // called by the solver; the shift is built in
  void perform_op(const double* x_in, double* y_out) const {
    const Eigen::Map<const Eigen::VectorXd> x(x_in, rows());
    Eigen::Map<Eigen::VectorXd> y(y_out, rows());
    y = root_degree_.cwiseProduct(solver_.solve(root_degree_.cwiseProduct(x)));
  }

 private:
  Eigen::VectorXd root_degree_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

struct Pairs {
  Eigen::VectorXd values;   // ascending
  Eigen::MatrixXd vectors;  // of the normalised Laplacian
};

Pairs sparsePairs(const WeightedGraph& graph, const Eigen::VectorXd& degree, int wanted) {
  InverseNormalizedLaplacian inverse(graph, degree);
  const Eigen::Index basis = std::min<Eigen::Index>(degree.size(), 2 * wanted + 8);
  Spectra::SymEigsShiftSolver<InverseNormalizedLaplacian> solver(inverse, wanted, basis, -kShift);
  solver.init();  // a fixed pseudo-random vector: the result is the same each time
  solver.compute(Spectra::SortRule::LargestMagn, kMaxIterations, kTolerance,
                 Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw std::runtime_error("laplacianEigenmap: the eigen-solver did not converge");
  }
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Pairs densePairs(const WeightedGraph& graph, const Eigen::VectorXd& degree, int wanted) {
  const Eigen::VectorXd scale = degree.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd laplacian = shiftedLaplacian(graph, degree, 0.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * laplacian *
                                                              scale.asDiagonal());
  return {solver.eigenvalues().head(wanted), solver.eigenvectors().leftCols(wanted)};
}

}  // namespace

Eigenmap laplacianEigenmap(const WeightedGraph& graph, int modes) {
  if (modes < 1) throw std::invalid_argument("laplacianEigenmap: modes must be at least 1");
  const int existing = std::max(0, int(graph.nodeCount()) - 1);
  const int count = std::min(modes, existing);
  if (count == 0) return {Eigen::VectorXd(0), Eigen::MatrixXd(graph.nodeCount(), 0)};
  const Eigen::VectorXd degree = degrees(graph);
  const bool dense = existing < kLargestDense || existing < 4 * modes;
  const Pairs pairs =
      dense ? densePairs(graph, degree, count + 1) : sparsePairs(graph, degree, count + 1);
  // The first pair is lambda = 0 with the constant vector.
  Eigenmap map{pairs.values.tail(count), Eigen::MatrixXd()};
  const Eigen::VectorXd scale = (degree.cwiseInverse() * degree.sum()).cwiseSqrt();
  map.vectors = scale.asDiagonal() * pairs.vectors.rightCols(count);
  for (int mode = 0; mode < count; ++mode) {
    Eigen::Index largest = 0;
    map.vectors.col(mode).cwiseAbs().maxCoeff(&largest);
    if (map.vectors(largest, mode) < 0.0) map.vectors.col(mode) *= -1.0;
  }
  return map;
}

}  // namespace markerless_mocap
