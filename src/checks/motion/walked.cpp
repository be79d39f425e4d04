#include "checks/motion/walked.h"

#include <cmath>

#include "checks/stamps/stream_times.h"

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
  return std::hypot(quantile(x, 0.9) - quantile(x, 0.1), quantile(y, 0.9) - quantile(y, 0.1));
}

}  // namespace markerless_mocap
