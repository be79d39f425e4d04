#include "calibration/adjust/bundle.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "calibration/adjust/corner_cost.h"
#include "calibration/adjust/lens_prior.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

using PriorCost = ceres::AutoDiffCostFunction<LensPrior, 12, 12>;
using PointCost = ceres::AutoDiffCostFunction<PointResidual, 2, 12, 6>;

bool contributes(const Instant& instant) {
  if (!instant.located) return false;
  return std::any_of(instant.views.begin(), instant.views.end(),
                     [](const ViewSight& view) { return view.used; });
}

/// The problem of one adjustment; its blocks lie in the state.
class Bundle {
 public:
  Bundle(const Board& board, const BundleOptions& options, RigState* state)
      : board_(board), options_(options), state_(*state), loss_(options.loss_pixels) {
    ceres::Problem::Options ownership;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    problem_ = std::make_unique<ceres::Problem>(ownership);
    for (CameraState& camera : state_.cameras) addCamera(&camera);
    for (Instant& instant : state_.instants)
      if (contributes(instant)) addInstant(&instant);
    for (const KnownPoint& point : state_.points) addPoint(point);
    for (size_t i = 0; i < state_.cameras.size(); ++i) hold(i);
  }

  void solve() {
    constexpr size_t kDense = 24;  // cameras up to which the reduced equations are solved as dense
    // Some damping stays when steps succeed: of a rational lens, k4 k5 k6 do nearly what k1 k2 k3
    // do, and undamped equations have no Cholesky factors.
    constexpr double kLeastDamping = 1e8;
    ceres::Solver::Options options;
    options.max_num_iterations = options_.iterations;
    options.num_threads = options_.threads;
    options.linear_solver_type =
        state_.cameras.size() <= kDense ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
    options.linear_solver_ordering.reset(ordering_);
    ordering_ = nullptr;
    options.function_tolerance = 1e-9;
    options.max_trust_region_radius = kLeastDamping;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, problem_.get(), &summary);
    if (!summary.IsSolutionUsable())
      throw std::runtime_error("the adjustment of the cameras failed: " + summary.message);
  }

 private:
  void addCamera(CameraState* camera) {
    problem_->AddParameterBlock(camera->intrinsics.data(), 12);
    problem_->AddResidualBlock(new PriorCost(new LensPrior(commonLens(*camera, state_.view_sigma))),
                               nullptr, camera->intrinsics.data());
    problem_->AddParameterBlock(camera->camera_world.data(), 6);
    problem_->AddParameterBlock(&camera->time_offset, 1);
    ordering_->AddElementToGroup(camera->intrinsics.data(), 1);
    ordering_->AddElementToGroup(camera->camera_world.data(), 1);
    ordering_->AddElementToGroup(&camera->time_offset, 1);
  }

  void addInstant(Instant* instant) {
    problem_->AddParameterBlock(instant->world_board.data(), 6);
    ordering_->AddElementToGroup(instant->world_board.data(), 0);
    for (const ViewSight& view : instant->views) {
      if (!view.used) continue;
      CameraState& camera = state_.cameras[view.camera];
      for (const CornerSight& corner : view.corners) {
        if (!corner.used) continue;
        const CornerResidual residual{board_.corners()[corner.id], corner.pixel, corner.motion,
                                      instant->time - view.time, typeOf(camera.lens)};
        problem_->AddResidualBlock(new CornerCost(residual), &loss_, camera.intrinsics.data(),
                                   camera.camera_world.data(), instant->world_board.data(),
                                   &camera.time_offset);
      }
    }
  }

  /// Points count by how well they are known against corners.
  void addPoint(const KnownPoint& point) {
    const double sigma = sigmaOf(state_, point), corner = state_.corner_sigma;
    point_losses_.push_back(std::make_unique<ceres::ScaledLoss>(
        new ceres::CauchyLoss(kPointLoss * sigma), corner * corner / (sigma * sigma),
        ceres::TAKE_OWNERSHIP));
    ceres::LossFunction* const loss = point_losses_.back().get();
    for (const auto& [index, pixel] : point.pixels) {
      CameraState& camera = state_.cameras[index];
      problem_->AddResidualBlock(
          new PointCost(new PointResidual{point.position, pixel, typeOf(camera.lens)}), loss,
          camera.intrinsics.data(), camera.camera_world.data());
    }
  }

  void hold(size_t index) {
    CameraState& camera = state_.cameras[index];
    const bool held = options_.held.count(index) > 0;
    if (held) problem_->SetParameterBlockConstant(camera.camera_world.data());
    const bool clock_held = held || (options_.held.empty() && index == 0);
    if (clock_held || !options_.estimate_offsets)
      problem_->SetParameterBlockConstant(&camera.time_offset);
    const std::vector<int> fixed = fixedIntrinsics(camera.lens);
    if (camera.intrinsics_fixed || !options_.estimate_intrinsics)
      problem_->SetParameterBlockConstant(camera.intrinsics.data());
    else if (!fixed.empty())
      problem_->SetManifold(camera.intrinsics.data(), new ceres::SubsetManifold(12, fixed));
  }

  const Board& board_;
  const BundleOptions& options_;
  RigState& state_;
  ceres::CauchyLoss loss_;
  std::vector<std::unique_ptr<ceres::LossFunction>> point_losses_;  // outlive the problem
  std::unique_ptr<ceres::Problem> problem_;
  ceres::ParameterBlockOrdering* ordering_ = new ceres::ParameterBlockOrdering;
};

template <class VisitT>
void forEachCorner(const RigState& state, const VisitT& visit) {
  for (const Instant& instant : state.instants)
    if (instant.located)
      for (const ViewSight& view : instant.views)
        if (view.used)
          for (const CornerSight& corner : view.corners) visit(instant, view, corner);
}

}  // namespace

void adjustBundle(const Board& board, const BundleOptions& options, RigState* state) {
  Bundle(board, options, state).solve();
}

double robustSigma(const Board& board, const RigState& state) {
  std::vector<double> sizes;
  forEachCorner(state, [&](const Instant& instant, const ViewSight& view, const CornerSight& c) {
    const Eigen::Vector2d r = residualOf(state, board, instant, view, c);
    if (r.allFinite()) sizes.insert(sizes.end(), {std::abs(r.x()), std::abs(r.y())});
  });
  if (sizes.empty()) return 0.0;
  return 1.4826 * medianAmong(sizes);
}

int markOutliers(const Board& board, double limit, RigState* state) {
  int outliers = 0;
  for (Instant& instant : state->instants)
    for (ViewSight& view : instant.views)
      for (CornerSight& corner : view.corners) {
        corner.used = residualOf(*state, board, instant, view, corner).norm() < limit;
        outliers += view.used && instant.located && !corner.used;
      }
  return outliers;
}

}  // namespace markerless_mocap
