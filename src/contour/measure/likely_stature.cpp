#include "contour/measure/likely_stature.h"

#include <array>

namespace markerless_mocap {
namespace {

// Metres. A smaller body, folded, fits the raised arm of somebody of whom nothing else is seen.
constexpr std::array<double, 5> kUsualStatures{1.5, 1.6, 1.7, 1.8, 1.9};
constexpr double kStatureStep = 0.15, kSmallest = 1.15, kLargest = 2.35;

}  // namespace

double likelyStature(double expected, const std::function<double(double stature)>& quality) {
  double best_stature = expected, best_quality = 0.0;
  const auto isBetter = [&](double stature) {
    const double one = quality(stature);
    if (one <= best_quality) return false;
    best_quality = one;
    best_stature = stature;
    return true;
  };
  isBetter(expected);
  for (const double stature : kUsualStatures) isBetter(stature);
  for (double stature = best_stature; stature >= kUsualStatures.back() && stature < kLargest;)
    if (!isBetter(stature += kStatureStep)) break;
  for (double stature = best_stature;
       stature <= kUsualStatures.front() && stature - kStatureStep > kSmallest;)
    if (!isBetter(stature -= kStatureStep)) break;
  return best_stature;
}

}  // namespace markerless_mocap
