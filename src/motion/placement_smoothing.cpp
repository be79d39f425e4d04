#include "motion/placement_smoothing.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

double mirrored(const std::vector<double>& values, long i) {
  const long last = long(values.size()) - 1;
  const long end = i < 0 ? 0 : last;
  if (i >= 0 && i <= last) return values[size_t(i)];
  return 2.0 * values[size_t(end)] - values[size_t(std::clamp(2 * end - i, 0L, last))];
}

}  // namespace

std::vector<double> gaussianMean(const std::vector<double>& values, double sigma) {
  const long reach = long(std::ceil(3.0 * sigma));
  if (reach < 1 || values.size() < 2) return values;
  std::vector<double> kernel;
  for (long k = -reach; k <= reach; ++k)
    kernel.push_back(std::exp(-0.5 * double(k * k) / (sigma * sigma)));
  std::vector<double> out;
  for (long i = 0; i < long(values.size()); ++i) {
    double sum = 0.0, weights = 0.0;
    for (long k = -reach; k <= reach; ++k) {
      sum += kernel[size_t(k + reach)] * mirrored(values, i + k);
      weights += kernel[size_t(k + reach)];
    }
    out.push_back(sum / weights);
  }
  return out;
}

std::vector<double> runningMinimum(const std::vector<double>& values, long reach) {
  std::vector<double> out;
  for (long i = 0; i < long(values.size()); ++i) {
    const long first = std::max(0L, i - reach), last = std::min(long(values.size()) - 1, i + reach);
    out.push_back(*std::min_element(values.begin() + first, values.begin() + last + 1));
  }
  return out;
}

}  // namespace markerless_mocap
