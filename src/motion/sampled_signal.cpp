#include "motion/sampled_signal.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

double prolonged(const std::vector<double>& signal, int i) {
  return signal[size_t(std::clamp(i, 0, int(signal.size()) - 1))];
}

/// \param weights of the samples from -reach to +reach
std::vector<double> averaged(const std::vector<double>& signal,
                             const std::vector<double>& weights) {
  const int reach = int(weights.size()) / 2;
  double total = 0.0;
  for (double weight : weights) total += weight;
  std::vector<double> result(signal.size(), 0.0);
  for (int i = 0; i < int(signal.size()); ++i) {
    for (int k = -reach; k <= reach; ++k)
      result[size_t(i)] += weights[size_t(k + reach)] * prolonged(signal, i + k);
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
  return averaged(signal, weights);
}

std::vector<double> smoothFloor(const std::vector<double>& signal, int reach) {
  std::vector<double> lowest(signal.size());
  for (int i = 0; i < int(signal.size()); ++i) {
    lowest[size_t(i)] = signal[size_t(i)];
    for (int k = -reach; k <= reach; ++k)
      lowest[size_t(i)] = std::min(lowest[size_t(i)], prolonged(signal, i + k));
  }
  std::vector<double> hann;
  for (int k = -reach; k <= reach; ++k) hann.push_back(1.0 + std::cos(M_PI * k / (reach + 1.0)));
  return averaged(lowest, hann);
}

}  // namespace markerless_mocap
