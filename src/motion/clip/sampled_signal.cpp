#include "motion/clip/sampled_signal.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

double prolonged(const std::vector<double>& signal, int i) {
  return signal[size_t(std::clamp(i, 0, int(signal.size()) - 1))];
}

double mirrored(const std::vector<double>& signal, int i) {
  const int end = i < 0 ? 0 : int(signal.size()) - 1;
  if (i >= 0 && i <= end) return signal[size_t(i)];
  return 2.0 * signal[size_t(end)] - prolonged(signal, 2 * end - i);
}

/// \param weights weights of the samples from -reach to +reach
/// \param at returns a sample of the signal, also beyond its ends
std::vector<double> averaged(const std::vector<double>& signal, const std::vector<double>& weights,
                             double (*at)(const std::vector<double>&, int)) {
  const int reach = int(weights.size()) / 2;
  double total = 0.0;
  for (double weight : weights) total += weight;
  std::vector<double> result(signal.size(), 0.0);
  for (int i = 0; i < int(signal.size()); ++i) {
    for (int k = -reach; k <= reach; ++k)
      result[size_t(i)] += weights[size_t(k + reach)] * at(signal, i + k);
    result[size_t(i)] /= total;
  }
  return result;
}

}  // namespace

std::vector<double> smoothed(const std::vector<double>& signal, double sigma) {
  const int reach = int(std::ceil(3.5 * sigma));
  std::vector<double> weights;
  for (int k = -reach; k <= reach; ++k)
    weights.push_back(std::exp(-0.5 * k * k / std::max(sigma * sigma, 1e-12)));
  return averaged(signal, weights, mirrored);
}

std::vector<double> slidingMinimum(const std::vector<double>& signal, int reach) {
  std::vector<double> minimum;
  for (int i = 0; i < int(signal.size()); ++i) {
    const int first = std::max(0, i - reach), last = std::min(int(signal.size()) - 1, i + reach);
    minimum.push_back(*std::min_element(signal.begin() + first, signal.begin() + last + 1));
  }
  return minimum;
}

std::vector<double> smoothLowerEnvelope(const std::vector<double>& signal, int reach) {
  std::vector<double> hann;
  for (int k = -reach; k <= reach; ++k) hann.push_back(1.0 + std::cos(M_PI * k / (reach + 1.0)));
  return averaged(slidingMinimum(signal, reach), hann, prolonged);
}

}  // namespace markerless_mocap
