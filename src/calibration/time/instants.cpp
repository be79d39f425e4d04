#include "calibration/time/instants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

/// Indices of a camera's views that were not taken alone, by time.
std::vector<size_t> filmOf(const std::vector<BoardView>& views, size_t camera) {
  std::vector<size_t> film;
  for (size_t i = 0; i < views.size(); ++i)
    if (views[i].camera == camera && !views[i].alone) film.push_back(i);
  std::sort(film.begin(), film.end(),
            [&](size_t a, size_t b) { return views[a].time < views[b].time; });
  return film;
}

const Eigen::Vector2d* pixelOf(const BoardCorners& corners, int id) {
  const auto found = std::lower_bound(corners.ids.begin(), corners.ids.end(), id);
  if (found == corners.ids.end() || *found != id) return nullptr;
  return &corners.pixels[found - corners.ids.begin()];
}

/// A parabola through three times, or a line through two.
CornerMotion motionOf(const BoardView& view, size_t corner, const BoardView* before,
                      const BoardView* after) {
  const int id = view.corners.ids[corner];
  const Eigen::Vector2d& here = view.corners.pixels[corner];
  const Eigen::Vector2d* p = before ? pixelOf(before->corners, id) : nullptr;
  const Eigen::Vector2d* n = after ? pixelOf(after->corners, id) : nullptr;
  const double h = p ? view.time - before->time : 0.0, g = n ? after->time - view.time : 0.0;
  if (p && n) {
    const Eigen::Vector2d left = (here - *p) / h, right = (*n - here) / g;
    return {(left * g + right * h) / (g + h), 2.0 * (right - left) / (g + h)};
  }
  if (p) return {(here - *p) / h, Eigen::Vector2d::Zero()};
  if (n) return {(*n - here) / g, Eigen::Vector2d::Zero()};
  return {Eigen::Vector2d::Constant(NAN), Eigen::Vector2d::Constant(NAN)};
}

double timeOf(const std::vector<BoardView>& views, const std::vector<double>& offsets, size_t i) {
  return views[i].time + offsets[views[i].camera];
}

/// A view with the corners that can be moved to the time of its instant.
ViewSight sightOf(const BoardView& view, size_t index, const std::vector<CornerMotion>& motions,
                  double lag, double free_lag) {
  ViewSight sight;
  sight.camera = view.camera;
  sight.view = index;
  sight.time = view.time;
  for (size_t k = 0; k < view.corners.ids.size(); ++k) {
    CornerSight corner{view.corners.ids[k], view.corners.pixels[k], motions[k]};
    if (!corner.motion.velocity.allFinite()) {
      if (std::abs(lag) > free_lag) continue;
      corner.motion = {};
    }
    sight.corners.push_back(corner);
  }
  return sight;
}

Instant instantOf(const std::vector<BoardView>& views,
                  const std::vector<std::vector<CornerMotion>>& motions,
                  const std::vector<double>& offsets, const std::vector<size_t>& group,
                  double free_lag) {
  constexpr size_t kLeastCorners = 4;
  Instant instant;
  for (const size_t i : group) instant.time += timeOf(views, offsets, i) / double(group.size());
  for (const size_t i : group) {
    const double lag = instant.time - timeOf(views, offsets, i);
    ViewSight sight = sightOf(views[i], i, motions[i], lag, free_lag);
    if (sight.corners.size() >= kLeastCorners) instant.views.push_back(sight);
  }
  return instant;
}

}  // namespace

double viewInterval(const std::vector<BoardView>& views, size_t camera) {
  const std::vector<size_t> film = filmOf(views, camera);
  std::vector<double> gaps;
  for (size_t i = 1; i < film.size(); ++i)
    gaps.push_back(views[film[i]].time - views[film[i - 1]].time);
  if (gaps.empty()) return 0.0;
  return medianAmong(gaps);
}

std::vector<std::vector<CornerMotion>> cornerMotions(const std::vector<BoardView>& views,
                                                     size_t cameras) {
  constexpr double kLongestGap = 2.5;  // in intervals
  std::vector<std::vector<CornerMotion>> motions(views.size());
  for (size_t i = 0; i < views.size(); ++i)
    motions[i].assign(views[i].corners.ids.size(), CornerMotion{});
  for (size_t camera = 0; camera < cameras; ++camera) {
    const std::vector<size_t> film = filmOf(views, camera);
    const double longest = kLongestGap * viewInterval(views, camera);
    for (size_t i = 0; i < film.size(); ++i) {
      const BoardView& view = views[film[i]];
      const BoardView* before = i > 0 ? &views[film[i - 1]] : nullptr;
      const BoardView* after = i + 1 < film.size() ? &views[film[i + 1]] : nullptr;
      if (before && !(view.time - before->time < longest)) before = nullptr;
      if (after && !(after->time - view.time < longest)) after = nullptr;
      for (size_t k = 0; k < motions[film[i]].size(); ++k)
        motions[film[i]][k] = motionOf(view, k, before, after);
    }
  }
  return motions;
}

std::vector<Instant> groupInstants(const std::vector<BoardView>& views,
                                   const std::vector<std::vector<CornerMotion>>& motions,
                                   const std::vector<double>& offsets) {
  double interval = 0.0;
  for (size_t camera = 0; camera < offsets.size(); ++camera)
    interval = std::max(interval, viewInterval(views, camera));
  const double reach = 0.5 * interval, free_lag = 0.05 * interval;
  std::vector<size_t> order(views.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return timeOf(views, offsets, a) < timeOf(views, offsets, b);
  });
  std::vector<Instant> instants;
  const auto close = [&](std::vector<size_t>* group) {
    if (group->empty()) return;
    Instant instant = instantOf(views, motions, offsets, *group, free_lag);
    if (!instant.views.empty()) instants.push_back(std::move(instant));
    group->clear();
  };
  std::vector<size_t> group;
  for (const size_t i : order) {
    std::vector<size_t> single = {i};
    if (views[i].alone) {
      close(&single);
      continue;
    }
    const bool repeated = std::any_of(group.begin(), group.end(), [&](size_t other) {
      return views[other].camera == views[i].camera;
    });
    const double since =
        group.empty() ? 0.0 : timeOf(views, offsets, i) - timeOf(views, offsets, group.front());
    if (repeated || since > reach) close(&group);
    group.push_back(i);
  }
  close(&group);
  return instants;
}

void keepTurns(int corners, size_t cameras, std::vector<BoardView>* views) {
  for (size_t camera = 0; camera < cameras; ++camera) {
    const std::vector<size_t> film = filmOf(*views, camera);
    for (size_t i = 1; i < film.size(); ++i) {
      const BoardCorners& before = (*views)[film[i - 1]].corners;
      BoardCorners& here = (*views)[film[i]].corners;
      double same = 0, turned = 0;
      for (size_t k = 0; k < here.ids.size(); ++k) {
        if (const auto* p = pixelOf(before, here.ids[k])) same += (here.pixels[k] - *p).norm();
        if (const auto* p = pixelOf(before, corners - 1 - here.ids[k]))
          turned += (here.pixels[k] - *p).norm();
      }
      if (turned < same) std::reverse(here.pixels.begin(), here.pixels.end());
    }
  }
}

}  // namespace markerless_mocap
