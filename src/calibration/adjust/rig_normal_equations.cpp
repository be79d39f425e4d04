#include "calibration/adjust/rig_normal_equations.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "calibration/adjust/bundle.h"
#include "calibration/adjust/corner_cost.h"
#include "calibration/adjust/lens_prior.h"

namespace markerless_mocap {
namespace {

Eigen::Matrix<double, 2, kPerCamera> cameraSlopes(const PixelSlopes& slopes,
                                                  const Eigen::Vector3d& in_camera) {
  Eigen::Matrix<double, 2, kPerCamera> J = Eigen::Matrix<double, 2, kPerCamera>::Zero();
  J.leftCols<3>() = slopes.point;
  J.middleCols<3>(3) = -slopes.point * crossMatrix(in_camera);
  J.middleCols<12>(kIntrinsics) = slopes.intrinsics;
  return J;
}

/// Of the Cauchy loss.
double robustWeight(double squares, double scale) {
  return 1.0 / (1.0 + squares / (scale * scale));
}

int cornersUsed(const Instant& instant) {
  int corners = 0;
  for (const ViewSight& view : instant.views)
    for (const CornerSight& corner : view.corners) corners += view.used && corner.used;
  return corners;
}

/// The adjustment bends to each instant, most where there are few: their residuals are too small
/// by what it took from them. Source: Bell and McCaffrey, Bias reduction in standard errors
/// (2002), whose CR2 this is.
void addScatter(const InstantPart& instant, const Eigen::MatrixXd& inverse,
                Eigen::MatrixXd* scatter) {
  constexpr double kLeastLeft = 0.02, kTiny = 1e-9;
  // In units of the parameters' uncertainty: parameters of which the instant says nothing, as
  // the pose of a camera that saw the board alone, have but rounding errors in it.
  const Eigen::MatrixXd own_inverse = inverse(instant.at, instant.at);
  const Eigen::VectorXd unit = own_inverse.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd per_unit = (unit.array() > 0).select(unit.cwiseInverse(), 0.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> own(unit.asDiagonal() * instant.normal *
                                                           unit.asDiagonal());
  const Eigen::VectorXd& values = own.eigenvalues();
  const int rank = int((values.array() > kTiny * values.maxCoeff()).count());
  if (rank == 0) return;
  const Eigen::VectorXd root = values.tail(rank).cwiseSqrt();
  const Eigen::MatrixXd vectors = own.eigenvectors().rightCols(rank);
  // normal = A^T A, gradient = A^T y
  const Eigen::MatrixXd A = root.asDiagonal() * vectors.transpose() * per_unit.asDiagonal();
  const Eigen::VectorXd y =
      root.cwiseInverse().asDiagonal() * vectors.transpose() * unit.asDiagonal() * instant.gradient;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> taken(A * own_inverse * A.transpose());
  const Eigen::VectorXd left = (1.0 - taken.eigenvalues().array()).max(kLeastLeft);
  const Eigen::VectorXd gradient =
      A.transpose() * (taken.eigenvectors() * left.cwiseSqrt().cwiseInverse().asDiagonal() *
                       taken.eigenvectors().transpose() * y);
  (*scatter)(instant.at, instant.at) += gradient * gradient.transpose();
}

}  // namespace

RigNormalEquations::RigNormalEquations(const Board& board, const RigState& state,
                                       const std::vector<int>& free)
    : board_(board), state_(state), size_(kPerCamera * int(state.cameras.size())), free_(free) {
  normal_ = Eigen::MatrixXd::Zero(size_, size_);
  for (const Instant& instant : state.instants)
    if (instant.located) addInstant(instant);
  variance_ = squares_ > 0 ? squares_ / std::max(1.0, residuals_ - double(free.size()))
                           : std::pow(state.corner_sigma, 2);
  known_ = Eigen::MatrixXd::Zero(size_, size_);
  known_scatter_ = Eigen::VectorXd::Zero(size_);
  for (const KnownPoint& point : state.points) addPoint(point);
  for (size_t i = 0; i < state.cameras.size(); ++i) addPriors(int(i));
  invert();
}

double RigNormalEquations::pointVariance() const {
  constexpr double kGuess = 1.0, kGuessCounts = 2.0;
  double squares = kGuess * kGuessCounts, redundancy = kGuessCounts;
  for (const PointPart& part : points_) {
    if (part.stated) continue;
    const auto own = covariance_.block<kPerCamera, kPerCamera>(part.at, part.at);
    const double taken = (part.slopes * own * part.slopes.transpose()).trace() / part.variance;
    squares += part.weight * part.squares;
    redundancy += part.weight * std::max(0.0, 2.0 - part.weight * taken);
  }
  return squares / redundancy;
}

double RigNormalEquations::viewVariance() const {
  const Eigen::VectorXd scattered = covariance().diagonal(), apart = covariance_.diagonal();
  double sum = 0;
  int count = 0;
  for (size_t i = 0; i < state_.cameras.size(); ++i)
    for (int k = 2; k < 4; ++k) {
      const Eigen::Index at = kPerCamera * Eigen::Index(i) + kIntrinsics + k;
      if (!(apart[at] > 0)) continue;
      sum += scattered[at] / apart[at];
      ++count;
    }
  return variance_ * (count > 0 ? std::max(1.0, sum / count) : 1.0);
}

Eigen::MatrixXd RigNormalEquations::covariance() const {
  constexpr int kEnough = 20;
  if (instants_.size() < kEnough) return covariance_;
  const Eigen::MatrixXd inverse = covariance_ / variance_;
  Eigen::MatrixXd scatter = variance_ * known_;
  scatter.diagonal() += known_scatter_;
  for (const InstantPart& instant : instants_) addScatter(instant, inverse, &scatter);
  return inverse * scatter * inverse;
}

void RigNormalEquations::invert() {
  const Eigen::MatrixXd H = (normal_ + known_)(free_, free_);
  const Eigen::VectorXd scale = H.diagonal().cwiseMax(1e-30).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * H * scale.asDiagonal();
  covariance_ = Eigen::MatrixXd::Zero(size_, size_);
  covariance_(free_, free_) = variance_ * scale.asDiagonal() *
                              scaled.completeOrthogonalDecomposition().pseudoInverse() *
                              scale.asDiagonal();
}

void RigNormalEquations::addInstant(const Instant& instant) {
  const int corners = cornersUsed(instant);
  if (corners < 4) return;  // they do not fix the pose of the board
  InstantPart part;
  std::vector<int> first(state_.cameras.size(), -1);
  for (const ViewSight& view : instant.views) {
    if (!view.used || first[view.camera] >= 0) continue;
    first[view.camera] = int(part.at.size());
    for (int k = 0; k < kPerCamera; ++k) part.at.push_back(kPerCamera * int(view.camera) + k);
  }
  const int size = int(part.at.size());
  part.normal = Eigen::MatrixXd::Zero(size, size);
  part.gradient = Eigen::VectorXd::Zero(size);
  Eigen::MatrixXd with_board = Eigen::MatrixXd::Zero(size, 6);
  Eigen::Matrix<double, 6, 6> board_normal = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> board_gradient = Eigen::Matrix<double, 6, 1>::Zero();
  for (const ViewSight& view : instant.views)
    for (const CornerSight& corner : view.corners) {
      if (!view.used || !corner.used) continue;
      const Slopes s = slopesAt(instant, view, corner);
      const int at = first[view.camera];
      const double w = s.weight;
      part.normal.block<kPerCamera, kPerCamera>(at, at) += w * s.camera.transpose() * s.camera;
      with_board.middleRows<kPerCamera>(at) += w * s.camera.transpose() * s.board;
      part.gradient.segment<kPerCamera>(at) += w * s.camera.transpose() * s.residual;
      board_normal += w * s.board.transpose() * s.board;
      board_gradient += w * s.board.transpose() * s.residual;
      squares_ += w * s.residual.squaredNorm();
    }
  const Eigen::MatrixXd eliminate = board_normal.ldlt().solve(with_board.transpose()).transpose();
  part.normal -= eliminate * with_board.transpose();
  part.gradient -= eliminate * board_gradient;
  normal_(part.at, part.at) += part.normal;
  residuals_ += 2 * corners - 6;
  instants_.push_back(std::move(part));
}

RigNormalEquations::Slopes RigNormalEquations::slopesAt(const Instant& instant,
                                                        const ViewSight& view,
                                                        const CornerSight& corner) const {
  const CameraState& camera = state_.cameras[view.camera];
  const Eigen::Isometry3d camera_board =
      isometry(camera.camera_world) * isometry(instant.world_board);
  Eigen::Vector3d on_board;
  on_board << board_.corners()[corner.id], 0;
  const Eigen::Vector3d in_camera = camera_board * on_board;
  const LensType lens = typeOf(camera.lens);
  const PixelSlopes pixel = pixelSlopes(lens, camera.intrinsics.data(), in_camera);
  const double after = instant.time - view.time - camera.time_offset;
  Slopes s;
  s.residual = residualOf(state_, board_, instant, view, corner);
  s.camera = cameraSlopes(pixel, in_camera);
  s.camera.col(kTime) = corner.motion.velocity + after * corner.motion.acceleration;
  s.board.leftCols<3>() = pixel.point * camera_board.linear();
  s.board.rightCols<3>() = -pixel.point * camera_board.linear() * crossMatrix(on_board);
  s.weight = robustWeight(s.residual.squaredNorm(), BundleOptions().loss_pixels);
  return s;
}

void RigNormalEquations::addPoint(const KnownPoint& point) {
  for (const auto& [index, pixel] : point.pixels) {
    const CameraState& camera = state_.cameras[index];
    const Eigen::Vector3d in_camera = isometry(camera.camera_world) * point.position;
    const LensType lens = typeOf(camera.lens);
    Eigen::Vector2d projected;
    projectPoint(lens, camera.intrinsics.data(), in_camera.data(), projected.data());
    const double sigma = sigmaOf(state_, point);
    PointPart part;
    part.at = kPerCamera * int(index);
    part.slopes = cameraSlopes(pixelSlopes(lens, camera.intrinsics.data(), in_camera), in_camera);
    part.squares = (projected - pixel).squaredNorm();
    part.weight = robustWeight(part.squares, kPointLoss * sigma);
    part.variance = sigma * sigma;
    part.stated = point.sigma > 0;
    known_.block<kPerCamera, kPerCamera>(part.at, part.at) +=
        part.weight * variance_ / part.variance * part.slopes.transpose() * part.slopes;
    points_.push_back(part);
  }
}

void RigNormalEquations::addPriors(int index) {
  constexpr double kCommon[] = {0.2, 0.1, 0.001, 0.001, 0.05};  // k1 k2 p1 p2 k3
  const CameraState& camera = state_.cameras[index];
  const LensPrior prior = commonLens(camera, state_.view_sigma);
  const int first = kPerCamera * index + kIntrinsics;
  for (int k = 0; k < 4 + coefficientsOf(camera.lens); ++k) {
    const double weight = std::pow(prior.noise / prior.sigma[k], 2);
    known_.diagonal()[first + k] += weight;
    // It is weighed by the noise of views, not by that of corners.
    known_scatter_[first + k] += weight * (prior.noise * prior.noise - variance_);
  }
  for (int k = coefficientsOf(camera.lens); k < int(std::size(kCommon)); ++k)
    known_.diagonal()[first + 4 + k] += variance_ / (kCommon[k] * kCommon[k]);
}

}  // namespace markerless_mocap
