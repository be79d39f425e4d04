#include "evaluation/uncertainty_calibration.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace markerless_mocap {
namespace {

constexpr size_t kBins = 5;

using Pairs = std::vector<std::pair<double, double>>;  ///< expected and actual, mm

UncertaintyBin binOf(Pairs::const_iterator begin, Pairs::const_iterator end) {
  UncertaintyBin bin{size_t(end - begin), 0.0, 0.0};
  for (auto pair = begin; pair != end; ++pair) {
    bin.expected_mm += pair->first * pair->first;
    bin.actual_mm += pair->second * pair->second;
  }
  const double frames = bin.frames == 0 ? NAN : double(bin.frames);
  bin.expected_mm = std::sqrt(bin.expected_mm / frames);
  bin.actual_mm = std::sqrt(bin.actual_mm / frames);
  return bin;
}

double normalised95(const Pairs& pairs) {
  if (pairs.empty()) return NAN;
  std::vector<double> ratios;
  for (const auto& [expected, actual] : pairs) ratios.push_back(actual / expected);
  const auto at = ratios.begin() + std::ptrdiff_t(std::ceil(0.95 * double(ratios.size()))) - 1;
  std::nth_element(ratios.begin(), at, ratios.end());
  return *at;
}

}  // namespace

UncertaintyCalibration uncertaintyCalibration(const std::string& point,
                                              const std::vector<double>& expected_m,
                                              const std::vector<double>& error_mm) {
  if (expected_m.size() != error_mm.size())
    throw std::invalid_argument("expected and actual errors need the same frames");
  Pairs pairs;
  for (size_t f = 0; f < expected_m.size(); ++f)
    if (std::isfinite(expected_m[f]) && std::isfinite(error_mm[f]))
      pairs.emplace_back(1e3 * expected_m[f], error_mm[f]);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  const UncertaintyBin all = binOf(pairs.begin(), pairs.end());
  const auto within = std::count_if(
      pairs.begin(), pairs.end(), [](const auto& pair) { return pair.second <= 2.0 * pair.first; });
  UncertaintyCalibration out;
  out.point = point;
  out.frames = pairs.size();
  out.expected_mm = all.expected_mm;
  out.actual_mm = all.actual_mm;
  out.fraction_within_two_sigma = pairs.empty() ? NAN : double(within) / double(pairs.size());
  out.normalised_95 = normalised95(pairs);
  for (size_t b = 0; b < kBins; ++b) {
    const auto begin = std::ptrdiff_t(b * pairs.size() / kBins);
    const auto end = std::ptrdiff_t((b + 1) * pairs.size() / kBins);
    if (begin < end) out.bins.push_back(binOf(pairs.begin() + begin, pairs.begin() + end));
  }
  return out;
}

}  // namespace markerless_mocap
