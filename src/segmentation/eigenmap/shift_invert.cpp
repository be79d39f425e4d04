#include <Spectra/SymEigsShiftSolver.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <stdexcept>

#include "segmentation/graph_modes.h"

namespace markerless_mocap {
namespace {

constexpr double kShift = 1e-5;      // makes L + shift D positive definite
constexpr double kTolerance = 1e-6;  // relative, of the shifted and inverted eigenvalues
constexpr int kMaxIterations = 300;

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

/// The operator x -> (A + shift I)^-1 x for A = D^-1/2 L D^-1/2. The eigenvalues of A are the
/// wanted lambdas; its eigenvectors are D^1/2 times the wanted vectors.
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
  // NOLINTBEGIN(readability-identifier-naming): Spectra calls them by these names
  void set_shift(double) {}  // the shift is fixed
  void perform_op(const double* x_in, double* y_out) const {
    const Eigen::Map<const Eigen::VectorXd> x(x_in, rows());
    Eigen::Map<Eigen::VectorXd> y(y_out, rows());
    y = root_degree_.cwiseProduct(solver_.solve(root_degree_.cwiseProduct(x)));
  }
  // NOLINTEND(readability-identifier-naming)

 private:
  Eigen::VectorXd root_degree_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// \param values, vectors of the normalised Laplacian; the first pair is lambda = 0 with the
///   constant vector
GraphModes withoutConstant(const WeightedGraph& graph, const Eigen::VectorXd& degree,
                           const Eigen::VectorXd& values, const Eigen::MatrixXd& vectors) {
  const Eigen::Index count = values.size() - 1;
  GraphModes modes{values.tail(count),
                   degree.cwiseSqrt().cwiseInverse().asDiagonal() * vectors.rightCols(count),
                   Eigen::VectorXd(count)};
  const Eigen::SparseMatrix<double> laplacian = shiftedLaplacian(graph, degree, 0.0);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd u = modes.vectors.col(k);
    const Eigen::VectorXd rest =
        laplacian.selfadjointView<Eigen::Lower>() * u - modes.values[k] * degree.cwiseProduct(u);
    modes.residuals[k] = rest.cwiseQuotient(degree.cwiseSqrt()).norm() / modes.values[k];
  }
  return modes;
}

}  // namespace

Eigen::VectorXd degreesOf(const WeightedGraph& graph) {
  Eigen::VectorXd degree = Eigen::VectorXd::Zero(Eigen::Index(graph.nodeCount()));
  for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      degree[node] += graph.weight[e];
    }
  }
  return degree;
}

GraphModes denseModes(const WeightedGraph& graph, int modes) {
  const Eigen::VectorXd degree = degreesOf(graph);
  const Eigen::VectorXd scale = degree.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd laplacian = shiftedLaplacian(graph, degree, 0.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * laplacian *
                                                              scale.asDiagonal());
  return withoutConstant(graph, degree, solver.eigenvalues().head(modes + 1),
                         solver.eigenvectors().leftCols(modes + 1));
}

GraphModes shiftInvertModes(const WeightedGraph& graph, int modes) {
  const Eigen::VectorXd degree = degreesOf(graph);
  InverseNormalizedLaplacian inverse(graph, degree);
  const Eigen::Index basis = std::min<Eigen::Index>(degree.size(), 2 * modes + 10);
  Spectra::SymEigsShiftSolver<InverseNormalizedLaplacian> solver(inverse, modes + 1, basis,
                                                                 -kShift);
  solver.init();  // starts from a fixed pseudo-random vector, so the result is reproducible
  solver.compute(Spectra::SortRule::LargestMagn, kMaxIterations, kTolerance,
                 Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw std::runtime_error("laplacianEigenmap: the eigen-solver did not converge");
  }
  return withoutConstant(graph, degree, solver.eigenvalues(), solver.eigenvectors());
}

}  // namespace markerless_mocap
