#include "contour/measure/likely_stature.h"

#include <array>

namespace markerless_mocap {
namespace {

// Metres. A smaller body, folded, fits the raised arm of somebody of whom nothing else is seen.
constexpr std::array<double, 5> kUsualStatures{1.5, 1.6, 1.7, 1.8, 1.9};
constexpr double kStatureStep = 0.15, kSmallest = 1.1, kLargest = 2.4;

using Quality = std::function<double(double stature)>;

RatedStature climbed(RatedStature from, double step, const Quality& quality) {
  for (double next = from.stature + step; next > kSmallest && next < kLargest; next += step) {
    const double one = quality(next);
    if (one <= from.quality) break;
    from = {next, one};
  }
  return from;
}

}  // namespace

double likelyStature(double expected, const Quality& quality) {
  RatedStature best{expected, quality(expected)};
  for (const double stature : kUsualStatures)
    if (const double one = quality(stature); one > best.quality) best = {stature, one};
  if (best.stature >= kUsualStatures.back()) return climbed(best, kStatureStep, quality).stature;
  if (best.stature <= kUsualStatures.front()) return climbed(best, -kStatureStep, quality).stature;
  return best.stature;
}

RatedStature betterStature(RatedStature from, const Quality& quality) {
  const RatedStature larger = climbed(from, kStatureStep, quality);
  return larger.stature > from.stature ? larger : climbed(from, -kStatureStep, quality);
}

}  // namespace markerless_mocap
