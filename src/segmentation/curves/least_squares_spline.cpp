#include "segmentation/curves/least_squares_spline.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr double kSmoothing = 1e-6;  // weight of second differences, per value

struct Basis {
  int first;                // control point of weights[0]
  Eigen::Vector4d weights;  // of four consecutive control points
};

Basis basisAt(double s, int pieces) {
  const double along = std::clamp(s, 0.0, 1.0) * pieces;
  const int piece = std::min(int(along), pieces - 1);
  const double t = along - piece;
  const double r = 1.0 - t;
  return {piece, Eigen::Vector4d(r * r * r, 3 * t * t * t - 6 * t * t + 4,
                                 3 * r * r * r - 6 * r * r + 4, t * t * t) /
                     6.0};
}

}  // namespace

LeastSquaresSpline::LeastSquaresSpline(const Eigen::VectorXd& sites, const Eigen::MatrixXd& values,
                                       const Eigen::VectorXd& weights, int pieces)
    : pieces_(pieces) {
  const int controls = pieces + 3;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(controls, controls);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(controls, values.cols());
  for (Eigen::Index i = 0; i < sites.size(); ++i) {
    const Basis basis = basisAt(sites[i], pieces);
    const Eigen::Vector4d weighted = weights[i] * basis.weights;
    normal.block<4, 4>(basis.first, basis.first) += weighted * basis.weights.transpose();
    right.middleRows<4>(basis.first) += weighted * values.row(i);
  }
  const Eigen::Vector3d bend(1.0, -2.0, 1.0);
  for (int c = 0; c + 2 < controls; ++c) {
    normal.block<3, 3>(c, c) += kSmoothing * weights.sum() * bend * bend.transpose();
  }
  controls_ = normal.ldlt().solve(right);
}

Eigen::VectorXd LeastSquaresSpline::at(double s) const {
  const Basis basis = basisAt(s, pieces_);
  return controls_.middleRows<4>(basis.first).transpose() * basis.weights;
}

}  // namespace markerless_mocap
