#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace markerless_mocap {

/// The value that a fraction of the others are not above: of n sorted values that at
/// fraction * (n - 1), rounded down. \param values not empty; they are put into another order
template <typename T>
T quantileAmong(std::vector<T>& values, double fraction) {
  const auto at = values.begin() + std::ptrdiff_t(fraction * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The middle value; of an even number the upper of the two in the middle. As quantileAmong().
template <typename T>
T medianAmong(std::vector<T>& values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename T>
T quantileOf(std::vector<T> values, double fraction) {
  return quantileAmong(values, fraction);
}

template <typename T>
T medianOf(std::vector<T> values) {
  return medianAmong(values);
}

/// As quantileOf(), but at fraction * (n - 1) rounded to the nearest; 0 if there are no values.
inline double nearestQuantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + std::lround(fraction * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Linear between the values, as in most statistics programs. \param sorted not empty
inline double interpolatedQuantile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * double(sorted.size() - 1);
  const size_t below = size_t(place), above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - double(below)) * (sorted[above] - sorted[below]);
}

}  // namespace markerless_mocap
