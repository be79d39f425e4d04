#include "calibration/adjust/uncertainty.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "calibration/adjust/bundle.h"
#include "calibration/adjust/corner_cost.h"

namespace markerless_mocap {
namespace {

// Parameters of a camera: translation and rotation of its frame (in its own axes), intrinsics,
// time.
constexpr int kPose = 0, kIntrinsics = 6, kTime = 18, kPerCamera = 19;

Eigen::Matrix<double, 2, kPerCamera> cameraSlopes(const PixelSlopes& slopes,
                                                  const Eigen::Vector3d& in_camera) {
  Eigen::Matrix<double, 2, kPerCamera> J = Eigen::Matrix<double, 2, kPerCamera>::Zero();
  J.leftCols<3>() = slopes.point;
  J.middleCols<3>(3) = -slopes.point * crossMatrix(in_camera);
  J.middleCols<12>(kIntrinsics) = slopes.intrinsics;
  return J;
}

/// The normal equations of the cameras, the boards' poses eliminated, and the scatter of the
/// gradients of whole instants.
class NormalEquations {
 public:
  NormalEquations(const Board& board, const RigState& state)
      : board_(board), state_(state), size_(kPerCamera * int(state.cameras.size())) {
    normal_ = Eigen::MatrixXd::Zero(size_, size_);
    scatter_ = normal_;
    for (const Instant& instant : state.instants)
      if (instant.located) addInstant(instant);
    for (const KnownPoint& point : state.points) addPoint(point);
  }

  /// Covariance of the free parameters; rows and columns of the others are 0.
  Eigen::MatrixXd covariance(const std::vector<int>& free) const {
    constexpr int kEnough = 20;  // instants for their scatter to be known
    const Eigen::MatrixXd H = normal_(free, free);
    const Eigen::VectorXd scale = H.diagonal().cwiseMax(1e-30).cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * H * scale.asDiagonal();
    const Eigen::MatrixXd inverse = scale.asDiagonal() *
                                    scaled.completeOrthogonalDecomposition().pseudoInverse() *
                                    scale.asDiagonal();
    const double variance = squares_ / std::max(1.0, residuals_ - double(free.size()));
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size_, size_);
    if (instants_ >= kEnough)
      all(free, free) = inverse * scatter_(free, free) * inverse * (instants_ / (instants_ - 1.0));
    else
      all(free, free) = variance * inverse;
    return all;
  }

 private:
  static int cornersUsed(const Instant& instant) {
    int corners = 0;
    for (const ViewSight& view : instant.views)
      for (const CornerSight& corner : view.corners) corners += view.used && corner.used;
    return corners;
  }

  void addInstant(const Instant& instant) {
    const int corners = cornersUsed(instant);
    if (corners < 4) return;  // they do not fix the pose of the board
    Eigen::MatrixXd with_board = Eigen::MatrixXd::Zero(size_, 6);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size_);
    Eigen::Matrix<double, 6, 6> board_normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> board_gradient = Eigen::Matrix<double, 6, 1>::Zero();
    for (const ViewSight& view : instant.views)
      for (const CornerSight& corner : view.corners) {
        if (!view.used || !corner.used) continue;
        const Slopes s = slopesAt(instant, view, corner);
        const int at = kPerCamera * int(view.camera);
        const double w = s.weight;
        normal_.block<kPerCamera, kPerCamera>(at, at) += w * s.camera.transpose() * s.camera;
        with_board.middleRows<kPerCamera>(at) += w * s.camera.transpose() * s.board;
        gradient.segment<kPerCamera>(at) += w * s.camera.transpose() * s.residual;
        board_normal += w * s.board.transpose() * s.board;
        board_gradient += w * s.board.transpose() * s.residual;
        squares_ += w * s.residual.squaredNorm();
      }
    const Eigen::MatrixXd eliminate = board_normal.ldlt().solve(with_board.transpose()).transpose();
    normal_ -= eliminate * with_board.transpose();
    gradient -= eliminate * board_gradient;
    scatter_ += gradient * gradient.transpose();
    residuals_ += 2 * corners - 6;
    ++instants_;
  }

  struct Slopes {
    Eigen::Vector2d residual;
    Eigen::Matrix<double, 2, kPerCamera> camera;
    Eigen::Matrix<double, 2, 6> board;
    double weight;
  };

  Slopes slopesAt(const Instant& instant, const ViewSight& view, const CornerSight& corner) const {
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
    s.weight = weightOf(s.residual);
    return s;
  }

  void addPoint(const KnownPoint& point) {
    for (const auto& [index, pixel] : point.pixels) {
      const CameraState& camera = state_.cameras[index];
      const Eigen::Vector3d in_camera = isometry(camera.camera_world) * point.position;
      const LensType lens = typeOf(camera.lens);
      const auto J =
          cameraSlopes(pixelSlopes(lens, camera.intrinsics.data(), in_camera), in_camera);
      Eigen::Vector2d projected;
      projectPoint(lens, camera.intrinsics.data(), in_camera.data(), projected.data());
      const Eigen::Vector2d r = projected - pixel;
      const double w = weightOf(r);
      const int at = kPerCamera * int(index);
      normal_.block<kPerCamera, kPerCamera>(at, at) += w * J.transpose() * J;
      const Eigen::VectorXd g = w * J.transpose() * r;
      scatter_.block<kPerCamera, kPerCamera>(at, at) += g * g.transpose();
      squares_ += w * r.squaredNorm();
      residuals_ += 2;
    }
  }

  /// Of the robust loss.
  static double weightOf(const Eigen::Vector2d& residual) {
    const double scale = BundleOptions().loss_pixels;
    return 1.0 / (1.0 + residual.squaredNorm() / (scale * scale));
  }

  const Board& board_;
  const RigState& state_;
  int size_;
  Eigen::MatrixXd normal_, scatter_;
  double squares_ = 0.0, residuals_ = 0.0, instants_ = 0.0;
};

std::vector<int> freeParameters(const RigState& state, const std::set<size_t>& held, bool offsets) {
  std::vector<int> free;
  for (size_t i = 0; i < state.cameras.size(); ++i) {
    const CameraState& camera = state.cameras[i];
    const int at = kPerCamera * int(i);
    if (held.count(i) == 0)
      for (int k = 0; k < 6; ++k) free.push_back(at + kPose + k);
    if (!camera.intrinsics_fixed)
      for (int k = 0; k < 4 + coefficientsOf(camera.lens); ++k)
        free.push_back(at + kIntrinsics + k);
    const bool clock_held = held.count(i) > 0 || (held.empty() && i == 0);
    if (offsets && !clock_held) free.push_back(at + kTime);
  }
  return free;
}

/// Takes out the motion of all cameras together. Source: Baarda's S-transformation, as in Triggs et
/// al. (2000), section 9.
Eigen::MatrixXd relativeToAll(const RigState& state, const Eigen::MatrixXd& covariance) {
  const int cameras = int(state.cameras.size());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(kPerCamera * cameras, 6);
  for (int i = 0; i < cameras; ++i) {
    const Eigen::Isometry3d T = isometry(state.cameras[i].camera_world);
    G.block<3, 3>(kPerCamera * i, 0) = T.linear();
    G.block<3, 3>(kPerCamera * i, 3) = crossMatrix(T.translation()) * T.linear();
    G.block<3, 3>(kPerCamera * i + 3, 3) = T.linear();
  }
  const Eigen::MatrixXd P = Eigen::MatrixXd::Identity(G.rows(), G.rows()) -
                            G * (G.transpose() * G).ldlt().solve(G.transpose());
  return P * covariance * P.transpose();
}

}  // namespace

std::vector<CameraUncertainty> uncertaintiesOf(const Board& board, const RigState& state,
                                               const std::set<size_t>& held, bool offsets) {
  Eigen::MatrixXd covariance =
      NormalEquations(board, state).covariance(freeParameters(state, held, offsets));
  if (state.points.empty()) covariance = relativeToAll(state, covariance);
  const Eigen::VectorXd sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  std::vector<CameraUncertainty> out;
  for (size_t i = 0; i < state.cameras.size(); ++i) {
    const Eigen::VectorXd own = sigma.segment<kPerCamera>(kPerCamera * int(i));
    out.push_back({own.head<3>(), own.segment<3>(3), own.segment<2>(kIntrinsics),
                   own.segment<2>(kIntrinsics + 2), own[kTime]});
  }
  return out;
}

}  // namespace markerless_mocap
