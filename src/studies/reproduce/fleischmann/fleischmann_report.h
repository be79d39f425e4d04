#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// The results of one variant over its seeds.
class VariantResults {
 public:
  VariantResults(const Results& results, const std::string& variant);

  size_t runs() const { return D_.size(); }
  double mean() const;       ///< Eq. 4.5 over all runs, mm
  double max() const;        ///< Eq. 4.6 over all runs, mm
  double medianMax() const;  ///< median over the runs of their maximum, mm
  /// D of each frame, mm: mean, maximum over the runs, and of one run.
  std::vector<double> meanOverRuns() const;
  std::vector<double> maxOverRuns() const;
  const std::vector<double>& D(size_t run) const { return D_.at(run); }
  const std::vector<double>& seconds() const { return seconds_; }
  const Json& json(size_t run) const { return *json_.at(run); }

 private:
  std::vector<const Json*> json_;
  std::vector<std::vector<double>> D_;
  std::vector<double> seconds_;
};

/// Adds chapter 6 to the page. \return the claims
std::vector<Claim> fleischmannReport(const Results& results, Page* page);

}  // namespace markerless_mocap
