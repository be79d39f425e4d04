#include "calibration/adjust/rig_adjustment.h"

#include <algorithm>
#include <cmath>

#include "calibration/adjust/uncertainty.h"
#include "calibration/start/pose_graph.h"
#include "calibration/time/instants.h"

namespace markerless_mocap {

BundleOptions RigAdjustment::options() const {
  BundleOptions options;
  options.estimate_offsets = offsets_free_;
  options.held = held_;
  options.threads = threads_;
  return options;
}

void RigAdjustment::regroup() {
  std::vector<double> offsets;
  for (const CameraState& camera : state_->cameras) offsets.push_back(camera.time_offset);
  state_->instants = groupInstants(views_, cornerMotions(views_, state_->cameras.size()), offsets);
}

/// Better offsets may group other views.
void RigAdjustment::regroupAndAdjust() {
  regroup();
  placeBoards(board_, poses_, state_);
  adjustBundle(board_, options(), state_);
}

void RigAdjustment::run() {
  adjustBundle(board_, options(), state_);
  if (offsets_free_) regroupAndAdjust();
  const double outlier_limit = std::max(1.0, 6.0 * robustSigma(board_, *state_));
  outliers_ = markOutliers(board_, outlier_limit, state_);
  estimateViewNoise(board_, held_, offsets_free_, state_);
  adjustBundle(board_, options(), state_);
  if (!state_->points.empty()) weighPoints();
}

/// Points read off by eye are far less exact than corners: how far, their residuals tell.
void RigAdjustment::weighPoints() {
  constexpr int kRounds = 8;
  for (int k = 0; k < kRounds && estimateNoise(board_, held_, offsets_free_, state_); ++k)
    adjustBundle(board_, options(), state_);
}

void RigAdjustment::checkClocks() {
  constexpr double kLeast = 0.005, kClear = 4.0, kBetter = 0.9;  // s, standard deviations, part
  if (offsets_free_ || state_->cameras.size() < 2) return;
  const double before = robustSigma(board_, *state_);
  const RigState without = *state_;
  offsets_free_ = true;
  run();
  const auto sigmas = uncertaintiesOf(board_, *state_, held_, true);
  bool clear = false;
  for (size_t i = 0; i < sigmas.size(); ++i)
    clear |=
        std::abs(state_->cameras[i].time_offset) > std::max(kLeast, kClear * sigmas[i].time_offset);
  if (clear && robustSigma(board_, *state_) < kBetter * before) return;
  offsets_free_ = false;
  *state_ = without;
}

}  // namespace markerless_mocap
