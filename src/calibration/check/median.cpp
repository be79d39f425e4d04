#include "calibration/check/median.h"

#include <algorithm>

namespace markerless_mocap {

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + long(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace markerless_mocap
