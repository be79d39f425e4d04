#include "calibration/adjust/lens_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/adjust/bundle.h"
#include "calibration/start/board_pose.h"
#include "calibration/start/camera_start.h"

namespace markerless_mocap {
namespace {

/// One camera at the origin with the views as instants.
RigState aloneState(const Board& board, const std::vector<const BoardView*>& views,
                    const Intrinsics& start, LensModel lens) {
  RigState state;
  state.cameras.resize(1);
  state.cameras[0].intrinsics = start;
  for (const int fixed : fixedIntrinsics(lens)) state.cameras[0].intrinsics[fixed] = 0.0;
  state.cameras[0].lens = lens;
  for (const BoardView* view : views) {
    const BoardPose pose = boardPose(board, view->corners, state.cameras[0].intrinsics);
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
std::vector<double> errorsOnViewsLeftOut(const Board& board,
                                         const std::vector<const BoardView*>& views,
                                         const Intrinsics& start, LensModel lens) {
  const size_t folds = std::min<size_t>(views.size(), 5);
  std::vector<double> errors;
  for (size_t fold = 0; fold < folds; ++fold) {
    std::vector<const BoardView*> kept, left_out;
    for (size_t i = 0; i < views.size(); ++i)
      (i % folds == fold ? left_out : kept).push_back(views[i]);
    const Intrinsics intrinsics = adjustIntrinsics(board, kept, start, lens);
    RigState test = aloneState(board, left_out, intrinsics, lens);
    BundleOptions options = aloneOptions();
    options.estimate_intrinsics = false;
    if (!test.instants.empty()) adjustBundle(board, options, &test);
    for (const Instant& instant : test.instants) errors.push_back(viewError(board, test, instant));
  }
  return errors;
}

double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / double(values.size());
}

}  // namespace

Intrinsics adjustIntrinsics(const Board& board, const std::vector<const BoardView*>& views,
                            const Intrinsics& start, LensModel lens) {
  RigState state = aloneState(board, views, start, lens);
  if (!state.instants.empty()) adjustBundle(board, aloneOptions(), &state);
  return state.cameras[0].intrinsics;
}

LensChoice chooseLens(const Board& board, const std::vector<const BoardView*>& views,
                      const Intrinsics& start) {
  constexpr size_t kViews = 40, kManyViews = 15;
  std::vector<const BoardView*> chosen;
  for (const size_t i : differentViews(board, views, kViews)) chosen.push_back(views[i]);
  LensChoice choice;
  double least = std::numeric_limits<double>::infinity();
  for (const LensModel lens : kLensModels) {
    const double error = std::sqrt(meanOf(errorsOnViewsLeftOut(board, chosen, start, lens)));
    choice.trials.push_back({lens, error});
    if (views.size() >= kManyViews && coefficientsOf(lens) < 4) continue;
    if (!(error < 0.995 * least)) continue;
    least = error;
    choice.lens = lens;
  }
  return choice;
}

}  // namespace markerless_mocap
