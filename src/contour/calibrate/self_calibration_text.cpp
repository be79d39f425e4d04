#include <algorithm>
#include <cmath>
#include <cstdio>

#include "contour/self_calibration.h"

namespace markerless_mocap {

const char* toString(OrientationRefinementStatus status) {
  constexpr const char* kNames[] = {"corrected", "no gain", "too few instants"};
  return kNames[size_t(status)];
}

std::string OrientationRefinement::sentence() const {
  if (status == OrientationRefinementStatus::kTooFewSamples)
    return "the cameras' pointing was not estimated: only " + std::to_string(samples_used) +
           " instants of different postures could be fitted, needed are 4";
  double squares = 0.0;
  for (const OrientationCorrection& one : corrections) squares += one.pixels.squaredNorm();
  char text[360];
  std::snprintf(text, sizeof text,
                "%s: by %d instants cameras point %.1f px off (root mean square); with that the "
                "overlap of body and silhouettes is %.3f instead of %.3f, the rays' distance from "
                "the body %.1f mm instead of %.1f",
                status == OrientationRefinementStatus::kCorrected
                    ? "the cameras' pointing is corrected"
                    : "the calibration is kept, as no other is surely better",
                samples_used, std::sqrt(squares / double(std::max<size_t>(1, corrections.size()))),
                after.overlap, before.overlap, 1e3 * after.distance, 1e3 * before.distance);
  return text;
}

std::string OrientationCorrection::sentence() const {
  char text[160];
  std::snprintf(text, sizeof text,
                " is turned by %.2f degrees: its image moves by %.1f px to the %s and %.1f px %s, "
                "each +- %.1f",
                turn * 180.0 / M_PI, std::abs(pixels.x()), pixels.x() < 0 ? "left" : "right",
                std::abs(pixels.y()), pixels.y() < 0 ? "up" : "down", deviation.maxCoeff());
  return camera + text;
}

}  // namespace markerless_mocap
