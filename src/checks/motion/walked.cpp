#include "checks/motion/walked.h"

#include <cmath>

#include "numerics/order_statistics.h"

namespace markerless_mocap {

double walkedIn(const std::vector<CameraState>& states) {
  std::vector<Rays> rays;
  for (const CameraState& state : states) rays.push_back(state.rays);
  const auto points = pointsOf(rays, {});
  std::vector<double> x, y;
  for (size_t at = size_t(BodyMark::kCentre); at < points.size(); at += kBodyMarks) {
    if (!points[at]) continue;
    x.push_back(points[at]->x());
    y.push_back(points[at]->y());
  }
  if (x.empty()) return 0;
  return std::hypot(nearestQuantile(x, 0.9) - nearestQuantile(x, 0.1),
                    nearestQuantile(y, 0.9) - nearestQuantile(y, 0.1));
}

}  // namespace markerless_mocap
