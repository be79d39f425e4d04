#include <tbb/parallel_for.h>

#include <limits>

#include "calibration/adjust/lens_choice.h"
#include "calibration/calibrate.h"
#include "calibration/time/instants.h"
#include "calibration/time/offset_search.h"

namespace markerless_mocap {
namespace {

constexpr size_t kLeastViews = 5;  // for a lens

/// Poses of the board before one camera, with a lens that is good enough for its way.
void poseBoards(const Board& board, const CalibrationInput& input,
                const std::vector<BoardView>& views, size_t camera, std::vector<BoardPose>* poses) {
  std::vector<const BoardView*> own;
  for (const BoardView& view : views)
    if (view.camera == camera) own.push_back(&view);
  const CameraToCalibrate& known = input.cameras[camera];
  if (!known.given && own.size() < kLeastViews) return;
  LensModel lens = input.lens.value_or(LensModel::kRadial2);
  Intrinsics intrinsics{};
  if (known.given) {
    intrinsics = intrinsicsOf(*known.given);
    lens = modelOf(*known.given);
  } else {
    lensFromViews(board, known, own, lens, &intrinsics);
  }
  for (size_t i = 0; i < views.size(); ++i)
    if (views[i].camera == camera && !views[i].alone)
      (*poses)[i] = boardPose(board, views[i].corners, intrinsics, lens);
}

}  // namespace

FilmClocks searchClocks(const CalibrationInput& input) {
  const Board board(input.board);
  std::vector<BoardView> views = input.views;
  if (board.looksSameTurned()) keepTurns(int(board.corners().size()), input.cameras.size(), &views);
  BoardPose none;
  none.rms = std::numeric_limits<double>::infinity();
  std::vector<BoardPose> poses(views.size(), none);
  tbb::parallel_for(size_t(0), input.cameras.size(),
                    [&](size_t camera) { poseBoards(board, input, views, camera, &poses); });
  return searchOffsets(board, input.cameras.size(), views, poses, input.largest_offset);
}

}  // namespace markerless_mocap
