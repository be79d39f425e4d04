#include "calibration/adjust/lens_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "calibration/adjust/bundle.h"
#include "calibration/start/board_pose.h"
#include "calibration/start/camera_start.h"

namespace markerless_mocap {
namespace {

/// One camera at the origin with the views as instants.
RigState aloneState(const Board& board, const CameraToCalibrate& camera,
                    const std::vector<const BoardView*>& views, const Intrinsics& start,
                    LensModel lens) {
  RigState state;
  state.cameras.resize(1);
  state.cameras[0].size << camera.width, camera.height;
  state.cameras[0].intrinsics = start;
  for (const int fixed : fixedIntrinsics(lens)) state.cameras[0].intrinsics[fixed] = 0.0;
  state.cameras[0].lens = lens;
  for (const BoardView* view : views) {
    const BoardPose pose = boardPose(board, view->corners, state.cameras[0].intrinsics, lens);
    if (!std::isfinite(pose.rms)) continue;
    Instant instant;
    instant.located = true;
    instant.world_board = poseVector(pose.camera_board);
    instant.views.resize(1);
    for (size_t i = 0; i < view->corners.ids.size(); ++i)
      instant.views[0].corners.push_back({view->corners.ids[i], view->corners.pixels[i], {}});
    state.instants.push_back(instant);
  }
  return state;
}

BundleOptions aloneOptions() {
  BundleOptions options;
  options.held = {0};
  options.iterations = 40;
  return options;
}

/// Mean square of a view's residuals, those beyond the loss scale counted as that.
double viewError(const Board& board, const RigState& state, const Instant& instant) {
  const double most = BundleOptions().loss_pixels;
  double sum = 0;
  for (const CornerSight& corner : instant.views[0].corners) {
    const double r = residualOf(state, board, instant, instant.views[0], corner).norm();
    sum += r < most ? r * r : most * most;
  }
  return sum / double(instant.views[0].corners.size());
}

/// Error of each view when the intrinsics come from the other folds.
std::vector<double> errorsOnViewsLeftOut(const Board& board, const CameraToCalibrate& camera,
                                         const std::vector<const BoardView*>& views,
                                         const Intrinsics& start, LensModel lens) {
  const size_t folds = std::min<size_t>(views.size(), 5);
  std::vector<double> errors;
  for (size_t fold = 0; fold < folds; ++fold) {
    std::vector<const BoardView*> kept, left_out;
    for (size_t i = 0; i < views.size(); ++i)
      (i % folds == fold ? left_out : kept).push_back(views[i]);
    const Intrinsics intrinsics = adjustIntrinsics(board, camera, kept, start, lens);
    RigState test = aloneState(board, camera, left_out, intrinsics, lens);
    BundleOptions options = aloneOptions();
    options.estimate_intrinsics = false;
    if (!test.instants.empty()) adjustBundle(board, options, &test);
    for (const Instant& instant : test.instants) errors.push_back(viewError(board, test, instant));
  }
  return errors;
}

/// Pixels; infinite if the model cannot be fitted to the views.
double rmsOnViewsLeftOut(const Board& board, const CameraToCalibrate& camera,
                         const std::vector<const BoardView*>& views, const Intrinsics& start,
                         LensModel lens) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<double> errors;
  try {
    errors = errorsOnViewsLeftOut(board, camera, views, start, lens);
  } catch (const std::runtime_error&) {
    return kNone;
  }
  if (errors.empty()) return kNone;
  double sum = 0;
  for (const double error : errors) sum += error;
  return std::isfinite(sum) ? std::sqrt(sum / double(errors.size())) : kNone;
}

constexpr double kBetter = 0.995;  // of an error: a difference that counts

/// Pixels, below which a fisheye is chosen instead.
double fisheyeLimit(const LensTrial& polynomial) {
  constexpr double kClearlyBetter = 0.98;
  return polynomial.rms * (polynomial.lens == LensModel::kRational ? 1 / kBetter : kClearlyBetter);
}

Intrinsics startOf(LensModel lens, const Board& board, const CameraToCalibrate& camera,
                   const std::vector<const BoardView*>& views) {
  return lens == LensModel::kFisheye ? startFisheye(board, camera, views)
                                     : startIntrinsics(board, camera, views);
}

}  // namespace

Intrinsics adjustIntrinsics(const Board& board, const CameraToCalibrate& camera,
                            const std::vector<const BoardView*>& views, const Intrinsics& start,
                            LensModel lens) {
  RigState state = aloneState(board, camera, views, start, lens);
  if (!state.instants.empty()) adjustBundle(board, aloneOptions(), &state);
  return state.cameras[0].intrinsics;
}

LensChoice chooseLens(const Board& board, const CameraToCalibrate& camera,
                      const std::vector<const BoardView*>& views) {
  constexpr size_t kViews = 40, kManyViews = 15;
  std::vector<const BoardView*> chosen;
  for (const size_t i : differentViews(board, views, kViews)) chosen.push_back(views[i]);
  const Intrinsics polynomial = startOf(LensModel::kRational, board, camera, views);
  const Intrinsics fisheye = startOf(LensModel::kFisheye, board, camera, views);
  LensChoice choice;
  choice.start = polynomial;
  LensTrial best{LensModel::kPlumbBob, std::numeric_limits<double>::infinity()}, wide = best;
  for (const LensModel lens : kLensModels) {
    const bool is_wide = lens == LensModel::kFisheye;
    const Intrinsics& start = is_wide ? fisheye : polynomial;
    const LensTrial trial{lens, rmsOnViewsLeftOut(board, camera, chosen, start, lens)};
    choice.trials.push_back(trial);
    if (views.size() >= kManyViews && coefficientsOf(lens) < 4) continue;
    if (is_wide)
      wide = trial;
    else if (trial.rms < kBetter * best.rms)
      best = trial;
  }
  choice.lens = best.lens;
  if (wide.rms < fisheyeLimit(best)) {
    choice.lens = LensModel::kFisheye;
    choice.start = fisheye;
  }
  return choice;
}

LensChoice lensFromViews(const Board& board, const CameraToCalibrate& camera,
                         const std::vector<const BoardView*>& views,
                         const std::optional<LensModel>& lens, Intrinsics* intrinsics) {
  constexpr size_t kViews = 60;
  LensChoice choice;
  if (lens)
    choice = {*lens, startOf(*lens, board, camera, views), {}};
  else
    choice = chooseLens(board, camera, views);
  std::vector<const BoardView*> different;
  for (const size_t k : differentViews(board, views, kViews)) different.push_back(views[k]);
  *intrinsics = adjustIntrinsics(board, camera, different, choice.start, choice.lens);
  return choice;
}

}  // namespace markerless_mocap
