#include "contour/fit/body_overlap.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "contour/fit/view_times.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector2d;

constexpr int kFractionBits = 4;  // of a coordinate, for OpenCV's drawing functions

constexpr size_t kFewestViews = 3;  // that agree on a pose

/// What reaches farther from the image's corner is not drawn, samples: nearly beside the camera
/// projections have any size, and OpenCV draws large ones row by row.
constexpr double kMaxReach = 1e6;

/// Projection of a sphere, in samples.
struct Disk {
  Vector2d middle;
  double radius;
};

std::optional<Disk> diskOf(const Camera& camera, int step, const Eigen::Vector3d& middle,
                           double radius) {
  const Eigen::Vector3d in_camera = camera.inCameraFrame(middle);
  const auto pixel = camera.projectFromCameraFrame(in_camera);
  if (!pixel) return std::nullopt;
  const Disk disk{*pixel / step, radius * camera.pixelsPerMetre(in_camera) / step};
  const double reach = disk.middle.cwiseAbs().maxCoeff() + disk.radius;
  if (!(reach < kMaxReach)) return std::nullopt;
  return disk;
}

cv::Point fixedPoint(const Vector2d& p) {
  constexpr double kOne = 1 << kFractionBits;
  return {int(std::lround(p.x() * kOne)), int(std::lround(p.y() * kOne))};
}

/// Draws the convex hull of two disks: both disks, and the quadrangle between their common
/// tangents.
void draw(const Disk& a, const Disk& b, cv::Mat& canvas) {
  for (const Disk& disk : {a, b})
    cv::circle(canvas, fixedPoint(disk.middle),
               int(std::lround(disk.radius * (1 << kFractionBits))), 255, cv::FILLED, cv::LINE_8,
               kFractionBits);
  const Vector2d way = b.middle - a.middle;
  const double length = way.norm(), sine = (a.radius - b.radius) / std::max(length, 1e-9);
  if (std::abs(sine) >= 1) return;  // one disk contains the other
  const Vector2d along = way / length, across(-along.y(), along.x());
  const double cosine = std::sqrt(1 - sine * sine);
  const Vector2d one = sine * along + cosine * across, other = sine * along - cosine * across;
  const cv::Point corners[] = {
      fixedPoint(a.middle + a.radius * one), fixedPoint(b.middle + b.radius * one),
      fixedPoint(b.middle + b.radius * other), fixedPoint(a.middle + a.radius * other)};
  cv::fillConvexPoly(canvas, corners, 4, 255, cv::LINE_8, kFractionBits);
}

}  // namespace

double viewOverlap(const ContourView& view, const Camera& camera, const ContourWorldCones& cones) {
  cv::Mat canvas = cv::Mat::zeros((camera.height() - 1) / view.step + 1,
                                  (camera.width() - 1) / view.step + 1, CV_8UC1);
  for (const ContourWorldCone& cone : cones) {
    const auto a = diskOf(camera, view.step, cone.a, cone.radius_a);
    const auto b = diskOf(camera, view.step, cone.b, cone.radius_b);
    if (a && b) draw(*a, *b, canvas);
  }
  const cv::Rect box(view.corner, view.person.size());
  cv::Mat seen = view.person;
  if (!view.known.empty()) {
    canvas(box) &= view.known;
    seen = view.person & view.known;
  }
  const double body = cv::countNonZero(canvas), person = cv::countNonZero(seen);
  const double both = cv::countNonZero(canvas(box) & seen);
  if (body == 0 || person == 0) return 0.0;
  return 0.5 * both / body + 0.5 * both / person;
}

std::vector<double> viewOverlaps(const ContourObservation& seen, const CameraRig& rig,
                                 const ContourWorldCones& cones) {
  std::vector<double> overlaps(rig.size(), 0.0);
  tbb::parallel_for(size_t(0), rig.size(), [&](size_t v) {
    if (seen.views[v].status == ViewStatus::kUsable)
      overlaps[v] = viewOverlap(seen.views[v], rig[v], conesIn(seen.views[v], cones));
  });
  return overlaps;
}

double reachedByMost(std::vector<double> values) {
  const size_t most = std::min(values.size(), std::max(kFewestViews, values.size() / 2 + 1));
  const auto last = values.begin() + std::ptrdiff_t(most - 1);
  std::nth_element(values.begin(), last, values.end(), std::greater<>());
  return *last;
}

}  // namespace markerless_mocap
