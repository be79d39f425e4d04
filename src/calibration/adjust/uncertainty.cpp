#include "calibration/adjust/uncertainty.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "calibration/adjust/corner_cost.h"
#include "calibration/adjust/rig_normal_equations.h"

namespace markerless_mocap {
namespace {

/// Coefficients that a polynomial model leaves at 0 are free here, too: they may be wrong.
int doubtfulCoefficients(LensModel lens) {
  return std::max(coefficientsOf(lens),
                  typeOf(lens) == LensType::kPolynomial ? coefficientsOf(LensModel::kPlumbBob) : 0);
}

std::vector<int> freeParameters(const RigState& state, const std::set<size_t>& held, bool offsets) {
  std::vector<int> free;
  for (size_t i = 0; i < state.cameras.size(); ++i) {
    const CameraState& camera = state.cameras[i];
    const int at = kPerCamera * int(i);
    if (held.count(i) == 0)
      for (int k = 0; k < 6; ++k) free.push_back(at + kPose + k);
    if (!camera.intrinsics_fixed)
      for (int k = 0; k < 4 + doubtfulCoefficients(camera.lens); ++k)
        free.push_back(at + kIntrinsics + k);
    const bool clock_held = held.count(i) > 0 || (held.empty() && i == 0);
    if (offsets && !clock_held) free.push_back(at + kTime);
  }
  return free;
}

/// Takes out the motion of all cameras together. Source: Baarda's S-transformation, as in Triggs et
/// al. (2000), section 9.
Eigen::MatrixXd relativeToAll(const RigState& state, const Eigen::MatrixXd& covariance) {
  const auto cameras = Eigen::Index(state.cameras.size());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(kPerCamera * cameras, 6);
  for (Eigen::Index i = 0; i < cameras; ++i) {
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
      RigNormalEquations(board, state, freeParameters(state, held, offsets)).covariance();
  if (state.points.empty()) covariance = relativeToAll(state, covariance);
  const Eigen::VectorXd sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  std::vector<CameraUncertainty> out;
  for (size_t i = 0; i < state.cameras.size(); ++i) {
    const Eigen::VectorXd own = sigma.segment<kPerCamera>(kPerCamera * Eigen::Index(i));
    out.push_back({own.head<3>(), own.segment<3>(3), own.segment<2>(kIntrinsics),
                   own.segment<2>(kIntrinsics + 2), own[kTime]});
  }
  return out;
}

void estimateViewNoise(const Board& board, const std::set<size_t>& held, bool offsets,
                       RigState* state) {
  const RigNormalEquations equations(board, *state, freeParameters(*state, held, offsets));
  state->view_sigma = std::max(1e-3, std::sqrt(equations.viewVariance()));
}

bool estimateNoise(const Board& board, const std::set<size_t>& held, bool offsets,
                   RigState* state) {
  constexpr double kSame = 0.05;
  const RigNormalEquations equations(board, *state, freeParameters(*state, held, offsets));
  const double before = state->point_sigma / state->corner_sigma;
  state->corner_sigma = std::max(1e-3, std::sqrt(equations.cornerVariance()));
  state->point_sigma = std::sqrt(equations.pointVariance());
  return std::abs(state->point_sigma / state->corner_sigma / before - 1.0) > kSame;
}

}  // namespace markerless_mocap
