#include "camera/camera_difference.h"

namespace markerless_mocap {
namespace {

constexpr double kApart = 0.01;      // m
constexpr double kTurnedBy = 0.003;  // rad

}  // namespace

bool seeDifferently(const Camera& a, const Camera& b) {
  if (a.width() != b.width() || a.height() != b.height()) return true;
  if ((a.position() - b.position()).norm() > kApart) return true;
  const double right = a.width() - 1.0, bottom = a.height() - 1.0;
  const Eigen::Vector2d pixels[] = {
      {right / 2, bottom / 2}, {0, 0}, {right, 0}, {0, bottom}, {right, bottom}};
  for (const Eigen::Vector2d& pixel : pixels)
    if ((a.rayDirection(pixel) - b.rayDirection(pixel)).norm() > kTurnedBy) return true;
  return false;
}

}  // namespace markerless_mocap
