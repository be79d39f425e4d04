#include "camera/film_clocks.h"

#include <algorithm>

namespace markerless_mocap {

double peakRatio(const std::vector<double>& values, size_t peak) {
  constexpr size_t kNear = 3;
  const size_t n = values.size(), first = peak > kNear ? peak - kNear : 0;
  for (size_t i = first; i < std::min(n, peak + kNear + 1); ++i)
    if (values[i] > values[peak]) peak = i;
  const double top = values[peak];
  size_t low = peak, high = peak;
  while (low > 0 && values[low] > top / 2) --low;
  while (high + 1 < n && values[high] > top / 2) ++high;
  double rival = 0;
  for (size_t i = 0; i < n; ++i)
    if (i < low || i > high) rival = std::max(rival, values[i]);
  return top > 0 ? top / std::max(rival, 1e-9) : 0.0;
}

}  // namespace markerless_mocap
