#include "tracking/calibration_scale.h"

#include <cstdio>

namespace markerless_mocap {
namespace {

// People are rarely taller or, from the age of four on, shorter, metres.
constexpr double kTallest = 2.15, kShortest = 1.0;
constexpr double kUsualStature = 1.75;

}  // namespace

std::string scaleFinding(double stature) {
  if (stature > kShortest && stature < kTallest) return "";
  char text[320];
  std::snprintf(text, sizeof text,
                "the calibration looks wrong: the person is %.2f m tall in it, so its metre is too "
                "%s; it is used as it is. For a person of %.2f m, all lengths must be multiplied "
                "by %.2f: check the unit and the size of the board's squares",
                stature, stature > kTallest ? "short" : "long", kUsualStature,
                kUsualStature / stature);
  return text;
}

}  // namespace markerless_mocap
