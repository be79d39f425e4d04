#include "checks/motion/sight_grid.h"

#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kScale2 = 12.0 * 12.0;  // px^2; a person walks half of that in half a step
constexpr double kParallel = 0.02;       // squared sine below which two rays give no point

/// Square of the distance of a point from a ray, px^2; infinite behind the camera.
double missed2(const SightGrid& camera, const Eigen::Vector3d& direction,
               const Eigen::Vector3d& place) {
  const Eigen::Vector3d to = place - camera.origin;
  if (direction.dot(to) <= 0) return INFINITY;
  return camera.focal * camera.focal * direction.cross(to).squaredNorm() / to.squaredNorm();
}

double lossOf2(double missed) {
  return std::isfinite(missed) ? missed / (missed + kScale2) : 1.0;
}

/// False if the rays are nearly parallel.
bool meet(const SightGrid& a, const SightGrid& b, const Eigen::Vector3d& along_a,
          const Eigen::Vector3d& along_b, GridPoint* point) {
  const Eigen::Vector3d apart = b.origin - a.origin;
  const double cosine = along_a.dot(along_b), sine2 = 1 - cosine * cosine;
  if (sine2 < kParallel) return false;
  point->sine2 = sine2;
  const double da = along_a.dot(apart), db = along_b.dot(apart);
  const double s = (da - cosine * db) / sine2, t = (cosine * da - db) / sine2;
  point->place = 0.5 * (a.origin + s * along_a + b.origin + t * along_b);
  point->missed = s > 0 && t > 0
                      ? missed2(a, along_a, point->place) + missed2(b, along_b, point->place)
                      : INFINITY;
  return true;
}

}  // namespace

SightGrid sightGridOf(const PersonTrack& track, const CameraModel& model, double step) {
  SightGrid grid;
  const Camera camera(model.calibration);
  grid.origin = camera.position();
  grid.focal = model.calibration.K(0, 0) * kModelWidth / model.calibration.width;
  if (track.seconds.empty()) return grid;
  grid.first = track.seconds.front();
  const Sight sight = sightOf(track, model.calibration, model.turn);
  const int count = int((track.seconds.back() - grid.first) / step) + 1;
  for (int mark = 0; mark < kBodyMarks; ++mark)
    for (int i = 0; i < count; ++i) {
      const auto pixel = pixelAt(track, sight, BodyMark(mark), grid.first + i * step);
      grid.directions[size_t(mark)].push_back(
          pixel ? Eigen::Vector3d(camera.rayDirection(*pixel).normalized())
                : Eigen::Vector3d(Eigen::Vector3d::Zero()));
      grid.marks += pixel.has_value();
    }
  return grid;
}

std::vector<GridPoint> pointsOf(const SightGrid& a, const SightGrid& b, int shift, int first,
                                int every) {
  std::vector<GridPoint> points;
  for (int mark = 0; mark < kBodyMarks; ++mark)
    for (int i = first; i < a.size(); i += every) {
      if (!a.has(mark, i) || !b.has(mark, i - shift)) continue;
      GridPoint point;
      point.index = i;
      point.mark = mark;
      if (meet(a, b, a.directions[size_t(mark)][size_t(i)],
               b.directions[size_t(mark)][size_t(i - shift)], &point))
        points.push_back(point);
    }
  return points;
}

GridLoss lossOf(const SightGrid& camera, const std::vector<GridPoint>& points, int shift) {
  GridLoss loss;
  for (const GridPoint& point : points) {
    if (!camera.has(point.mark, point.index - shift)) continue;
    const Eigen::Vector3d& along =
        camera.directions[size_t(point.mark)][size_t(point.index - shift)];
    loss.sum += lossOf2(point.missed + missed2(camera, along, point.place));
    ++loss.count;
  }
  return loss;
}

}  // namespace markerless_mocap
