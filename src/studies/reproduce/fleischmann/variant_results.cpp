#include <algorithm>
#include <cmath>

#include "evaluation/joint_error.h"
#include "studies/reproduce/fleischmann/fleischmann_report.h"
#include "studies/reproduce/result_cache.h"

namespace markerless_mocap {

VariantResults::VariantResults(const Results& results, const std::string& variant) {
  const std::string stem = variant + "_seed";
  for (const auto& [name, json] : results)
    if (name.compare(0, stem.size(), stem) == 0) {
      json_.push_back(&json);
      D_.push_back(numbersOf(json["D"]));
      seconds_ = numbersOf(json["seconds"]);
    }
}

double VariantResults::mean() const {
  return meanWithin(-HUGE_VAL, HUGE_VAL);
}

double VariantResults::meanWithin(double from, double to) const {
  std::vector<double> wanted;
  for (const auto& run : D_)
    for (size_t f = 0; f < run.size(); ++f)
      if (seconds_[f] >= from && seconds_[f] <= to) wanted.push_back(run[f]);
  return summaryStatistics(wanted).mean;
}

double VariantResults::max() const {
  const std::vector<double> most = maxOverRuns();
  return most.empty() ? NAN : *std::max_element(most.begin(), most.end());
}

double VariantResults::medianMax() const {
  std::vector<double> maxima;
  for (const auto& run : D_) maxima.push_back(summaryStatistics(run).max);
  return summaryStatistics(maxima).median;
}

std::vector<double> VariantResults::meanOverRuns() const {
  std::vector<double> mean(seconds_.size(), 0.0);
  for (const auto& run : D_)
    for (size_t f = 0; f < mean.size(); ++f) mean[f] += run[f] / double(D_.size());
  return mean;
}

std::vector<double> VariantResults::maxOverRuns() const {
  std::vector<double> most(seconds_.size(), 0.0);
  for (const auto& run : D_)
    for (size_t f = 0; f < most.size(); ++f) most[f] = std::max(most[f], run[f]);
  return most;
}

}  // namespace markerless_mocap
