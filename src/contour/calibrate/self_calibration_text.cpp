#include <algorithm>
#include <cmath>
#include <cstdio>

#include "contour/self_calibration.h"

namespace markerless_mocap {

const char* toString(OrientationRefinementStatus status) {
  constexpr const char* kNames[] = {"corrected", "no gain", "too few frames"};
  return kNames[size_t(status)];
}

std::string OrientationRefinement::summary() const {
  if (status == OrientationRefinementStatus::kTooFewSamples)
    return "the camera orientations were not estimated: only " + std::to_string(samples_used) +
           " frames of different postures could be fitted, at least 4 are needed";
  double squares = 0.0;
  for (const OrientationCorrection& one : corrections) squares += one.pixels.squaredNorm();
  char text[400];
  std::snprintf(
      text, sizeof text,
      "%s: in %d frames, images are shifted by %.1f px (root mean square); with the correction, "
      "the "
      "overlap of body and silhouettes is %.3f instead of %.3f, the distance of the rays from "
      "the body %.1f mm instead of %.1f mm",
      status == OrientationRefinementStatus::kCorrected
          ? "the camera orientations are corrected"
          : "the calibration is unchanged, because no other is significantly better",
      samples_used, std::sqrt(squares / double(std::max<size_t>(1, corrections.size()))),
      after.overlap, before.overlap, 1e3 * after.distance, 1e3 * before.distance);
  return text;
}

std::string OrientationCorrection::summary() const {
  char text[180];
  std::snprintf(text, sizeof text,
                " is rotated by %.2f degrees: its image moves by %.1f px to the %s and %.1f px %s, "
                "each +- %.1f px",
                turn * 180.0 / M_PI, std::abs(pixels.x()), pixels.x() < 0 ? "left" : "right",
                std::abs(pixels.y()), pixels.y() < 0 ? "up" : "down", deviation.maxCoeff());
  return camera + text;
}

}  // namespace markerless_mocap
