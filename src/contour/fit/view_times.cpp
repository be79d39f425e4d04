#include "contour/fit/view_times.h"

#include <cmath>
#include <optional>

namespace markerless_mocap {
namespace {

// s: stamps of cameras in step scatter by so much.
constexpr double kAtOnce = 0.002;

ContourWorldCones placed(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(pose, frames);
  body.place(frames, cones);
  return cones;
}

}  // namespace

void shiftViews(const ContourBody& body, const ContourMotion& motion,
                const std::vector<double>& later_s, ContourObservation* seen) {
  std::optional<ContourWorldCones> now;
  for (size_t i = 0; i < later_s.size(); ++i) {
    if (std::abs(later_s[i]) < kAtOnce) continue;
    if (!now) now = placed(body, motion.pose);
    const ContourWorldCones then = placed(body, boxPlus(motion.pose, later_s[i] * motion.velocity));
    auto shifts = std::make_shared<ConeShifts>();
    for (size_t c = 0; c < kContourCones; ++c)
      (*shifts)[c] = {then[c].a - (*now)[c].a, then[c].b - (*now)[c].b};
    seen->views[i].shifts = std::move(shifts);
  }
}

ContourWorldCones conesIn(const ContourView& view, const ContourWorldCones& cones) {
  ContourWorldCones out = cones;
  for (size_t c = 0; view.shifts && c < kContourCones; ++c) {
    out[c].a += (*view.shifts)[c].a;
    out[c].b += (*view.shifts)[c].b;
  }
  return out;
}

}  // namespace markerless_mocap
