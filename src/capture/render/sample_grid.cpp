#include "capture/render/sample_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace markerless_mocap {
namespace {

/// Least cosine to the axis. Straight edges are straight on a plane only, which no fisheye shows
/// whole.
constexpr double kBeside = 0.1;

[[noreturn]] void throwTooWide(const Camera& camera) {
  throw std::invalid_argument(
      "camera '" + camera.name() +
      "' sees beyond 84 degrees off its axis, which the studio does not render");
}

}  // namespace

SampleGrid::SampleGrid(const Camera& camera)
    : camera_(camera),
      T_camera_world_(camera.calibration().T_world_camera.inverse()),
      size_(2 * camera.width() + 1, 2 * camera.height() + 1),
      plane_(size_t(size_.area())) {
  tbb::parallel_for(0, size_.height, [&](int y) {
    for (int x = 0; x < size_.width; ++x) {
      const Eigen::Vector3d ray =
          T_camera_world_.linear() * camera_.rayDirection({0.5 * (x - 1), 0.5 * (y - 1)});
      if (!(ray.z() > kBeside)) throwTooWide(camera_);
      plane_[size_t(y) * size_.width + x] = ray.hnormalized().cast<float>();
    }
  });
  computeRanges();
  bend_ = strongestBend();
}

void SampleGrid::computeRanges() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  rows_.assign(size_.height, {kInfinity, -kInfinity});
  columns_.assign(size_.width, {kInfinity, -kInfinity});
  const auto widen = [](Range& range, float value) {
    range = {std::min(range.low, value), std::max(range.high, value)};
  };
  float farthest_squared = 0.0f;
  low_ = high_ = row(0)[0].cast<double>();
  for (int y = 0; y < size_.height; ++y)
    for (int x = 0; x < size_.width; ++x) {
      const Eigen::Vector2f& point = row(y)[x];
      widen(rows_[y], point.y());
      widen(columns_[x], point.x());
      low_ = low_.cwiseMin(point.cast<double>());
      high_ = high_.cwiseMax(point.cast<double>());
      farthest_squared = std::max(farthest_squared, point.squaredNorm());
    }
  farthest_squared_ = 1.1 * farthest_squared;
}

Eigen::Vector2d SampleGrid::place(const Eigen::Vector3d& point) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (point.z() <= 0.0 || point.head<2>().squaredNorm() > farthest_squared_ * point.z() * point.z())
    return {kNone, kNone};
  const auto pixel = camera_.project(camera_.calibration().T_world_camera * point);
  if (!pixel) return {kNone, kNone};
  return 2.0 * *pixel + Eigen::Vector2d::Ones();
}

/// The greatest second difference of place() over the plane. A function with second derivatives
/// below M differs from the linear one through a triangle's corners by less than M size^2 / 2; the
/// rest is a reserve for what the lattice of this search misses.
double SampleGrid::strongestBend() const {
  constexpr int kSteps = 24;
  constexpr double kStep = 1e-3;
  constexpr double kEighth = 3.14159265358979323846 / 4.0;  // of a turn
  const double reach = std::sqrt(farthest_squared_);
  double strongest = 0.0;
  for (int i = -kSteps; i <= kSteps; ++i)
    for (int j = -kSteps; j <= kSteps; ++j) {
      const Eigen::Vector3d middle(reach * i / kSteps, reach * j / kSteps, 1.0);
      for (int turn = 0; turn < 4; ++turn) {
        const double angle = turn * kEighth;
        const Eigen::Vector3d step(kStep * std::cos(angle), kStep * std::sin(angle), 0.0);
        const Eigen::Vector2d bend =
            (place(middle + step) - 2.0 * place(middle) + place(middle - step)) / (kStep * kStep);
        if (bend.allFinite()) strongest = std::max(strongest, bend.norm());
      }
    }
  return strongest;
}

cv::Rect SampleGrid::placesWithin(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
  if (high.x() < low_.x() || low.x() > high_.x() || high.y() < low_.y() || low.y() > high_.y())
    return {};
  const auto span = [](const std::vector<Range>& ranges, double from, double to) {
    const auto meets = [&](const Range& range) { return range.high >= from && range.low <= to; };
    const auto first = std::find_if(ranges.begin(), ranges.end(), meets);
    const auto last = std::find_if(ranges.rbegin(), ranges.rend(), meets);
    return cv::Range(int(first - ranges.begin()), int(ranges.rend() - last));
  };
  const cv::Range x = span(columns_, low.x(), high.x()), y = span(rows_, low.y(), high.y());
  if (x.start >= x.end || y.start >= y.end) return {};
  return {x.start, y.start, x.size(), y.size()};
}

}  // namespace markerless_mocap
