#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "calibration/still_board.h"

namespace markerless_mocap {
namespace {

constexpr double kStill = 0.5;  // pixels, between a corner and its mean

double farthest(const BoardView& view, const BoardCorners& mean, bool turned) {
  double most = 0;
  const size_t count = mean.pixels.size();
  for (size_t i = 0; i < count; ++i)
    most =
        std::max(most, (view.corners.pixels[turned ? count - 1 - i : i] - mean.pixels[i]).norm());
  return most;
}

/// The mean of the views of one camera; empty if the board moved or parts of it were hidden.
std::optional<BoardView> meanOf(const std::vector<const BoardView*>& views, size_t corners,
                                bool looks_same_turned) {
  BoardView mean = *views.front();
  std::fill(mean.corners.pixels.begin(), mean.corners.pixels.end(), Eigen::Vector2d::Zero());
  for (const BoardView* view : views) {
    if (view->corners.ids.size() != corners) return std::nullopt;
    const bool turned = looks_same_turned && farthest(*view, views.front()->corners, true) <
                                                 farthest(*view, views.front()->corners, false);
    if (farthest(*view, views.front()->corners, turned) > 2 * kStill) return std::nullopt;
    for (size_t i = 0; i < corners; ++i)
      mean.corners.pixels[i] +=
          view->corners.pixels[turned ? corners - 1 - i : i] / double(views.size());
  }
  for (const BoardView* view : views)
    if (std::min(farthest(*view, mean.corners, false),
                 looks_same_turned ? farthest(*view, mean.corners, true) : INFINITY) > kStill)
      return std::nullopt;
  return mean;
}

}  // namespace

bool mergeStillViews(size_t corners, bool looks_same_turned, std::vector<BoardView>* views) {
  std::map<size_t, std::vector<const BoardView*>> by_camera;
  std::vector<BoardView> merged;
  for (const BoardView& view : *views) {
    if (view.alone)
      merged.push_back(view);
    else
      by_camera[view.camera].push_back(&view);
  }
  if (by_camera.size() < 2) return false;
  double time = INFINITY;
  for (const auto& [camera, of_camera] : by_camera) time = std::min(time, of_camera.front()->time);
  for (const auto& [camera, of_camera] : by_camera) {
    auto mean = meanOf(of_camera, corners, looks_same_turned);
    if (!mean) return false;
    mean->time = time;
    merged.push_back(*mean);
  }
  *views = merged;
  return true;
}

}  // namespace markerless_mocap
