#include "studies/reproduce/fleischmann/fleischmann_report.h"

#include <algorithm>
#include <cmath>

#include "evaluation/joint_error.h"
#include "studies/reproduce/fleischmann/fleischmann_variants.h"
#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

std::string mm(double value) {
  return std::isfinite(value) ? formatNumber("%.1f", value) : "-";
}

void addTable(const Results& results, const FleischmannTable& table, Page* page) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& id : table.variants) {
    const VariantResults found(results, id);
    double lost = 0.0, swapped = 0.0, seconds = 0.0;
    for (size_t r = 0; r < found.runs(); ++r) {
      lost += found.json(r)["lost"].get<double>() / double(found.runs());
      swapped += numberOf(found.json(r)["legs_swapped"]) / double(found.runs());
      seconds += numberOf(found.json(r)["seconds_per_frame"]) / double(found.runs());
    }
    rows.push_back({fleischmannVariant(id).name, std::to_string(found.runs()), mm(found.mean()),
                    mm(found.max()), mm(found.medianMax()), formatPercent(swapped),
                    formatNumber("%.1f", lost), formatNumber("%.0f", 1e3 * seconds)});
  }
  page->table({"", "#runs", "#mean D, mm", "#maximum D, mm", "#median of the runs' maxima",
               "#legs swapped", "#lost frames", "#ms per frame"},
              rows);
}

/// Mean and maximum over the runs, of the variants of each frame rate.
void addGraphs(const Results& results, const FleischmannTable& table, Page* page) {
  for (const int fps : {60, 20}) {
    std::vector<PlotLine> mean, most;
    std::vector<double> seconds;
    for (const std::string& id : table.variants) {
      if (fleischmannVariant(id).fps != fps) continue;
      const VariantResults found(results, id);
      seconds = found.seconds();
      mean.push_back({fleischmannVariant(id).name, found.meanOverRuns()});
      most.push_back({fleischmannVariant(id).name, found.maxOverRuns()});
    }
    if (mean.empty()) continue;
    page->text("Mean of the runs:");
    page->lines(seconds, "s", mean, "mm");
    page->text("Maximum of the runs:");
    page->lines(seconds, "s", most, "mm");
  }
}

}  // namespace

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
  double sum = 0.0;
  for (const auto& run : D_) sum += summaryStatistics(run).mean / double(D_.size());
  return D_.empty() ? NAN : sum;
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

std::vector<Claim> fleischmannReport(const Results& results, Page* page) {
  for (const FleischmannTable& table : fleischmannTables()) {
    page->heading(table.id + " " + table.title);
    addTable(results, table, page);
    addGraphs(results, table, page);
  }
  const VariantResults fast(results, "base60"), slow(results, "base20");
  return {{"6.3, p. 49, Fig. 6.5(a)", "60 fps: mean 38.0 mm, maximum 86.4 mm",
           "mean " + mm(fast.mean()) + ", maximum " + mm(fast.max()),
           fast.mean() <= 38.0 && fast.max() <= 86.4 ? Verdict::kHolds : Verdict::kHoldsPartly},
          {"6.3, p. 49, Fig. 6.5(b)", "20 fps: mean 46.3 mm, maximum 129.4 mm",
           "mean " + mm(slow.mean()) + ", maximum " + mm(slow.max()),
           slow.mean() <= 46.3 && slow.max() <= 129.4 ? Verdict::kHolds : Verdict::kHoldsPartly}};
}

}  // namespace markerless_mocap
