#include "studies/reproduce/hsiao/hsiao_totals.h"

#include <algorithm>
#include <cmath>

#include "studies/reproduce/hsiao/hsiao_film.h"
#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {

Tracked trackedOf(const std::vector<const Json*>& runs) {
  Tracked sum{};
  std::vector<double> all, of_six, of_fewer;
  for (const Json* run : runs) {
    const double weight = 1.0 / double(runs.size());
    const std::vector<double> D = numbersOf((*run)["D"]);
    for (size_t f = 0; f < D.size(); ++f) {
      all.push_back(D[f]);
      const bool six = (*run)["six"].at(f).get<bool>();
      (six ? of_six : of_fewer).push_back(D[f]);
      sum.six += six ? weight / double(D.size()) : 0.0;
    }
    sum.lost += weight * numberOf((*run)["lost"]);
    sum.reset += weight * numberOf((*run)["reset"]);
    sum.swaps += weight * numberOf((*run)["swaps"]);
    sum.jitter += weight * numberOf((*run)["jitter"]);
  }
  sum.D = summaryStatistics(all);
  sum.D_of_six = summaryStatistics(of_six);
  sum.D_of_fewer = summaryStatistics(of_fewer);
  return sum;
}

std::vector<const Json*> publishedRuns(const Results& results, const std::string& sequence) {
  std::vector<const Json*> runs;
  for (const auto& [name, json] : results)
    if (name.rfind(sequence + "_published_seed", 0) == 0) runs.push_back(&json);
  return runs;
}

HsiaoTotals totalsOf(const Results& results) {
  HsiaoTotals totals;
  for (const HsiaoSequence& sequence : hsiaoSequences()) {
    for (const Json* run : publishedRuns(results, sequence.id)) totals.published.push_back(run);
    totals.basic.push_back(&results.at(sequence.id + "_basic"));
    const Json& ours = results.at(sequence.id + "_default");
    totals.ours.push_back(numberOf(ours["D_mean"]));
    totals.ours_lost.push_back(numberOf(ours["fraction_without_estimate"]));
  }
  return totals;
}

double shareWithin(const std::vector<const Json*>& runs, double limit) {
  size_t within = 0, all = 0;
  for (const Json* run : runs)
    for (const double d : numbersOf((*run)["D"])) {
      ++all;
      within += std::isfinite(d) && d <= limit;
    }
  return double(within) / double(std::max<size_t>(1, all));
}

PartTotals partsOf(const Results& results, const std::string& variant) {
  PartTotals sum;
  const double weight = 1.0 / double(hsiaoSequences().size());
  std::vector<double> curves(4, 0.0);
  for (const HsiaoSequence& sequence : hsiaoSequences()) {
    const Json& one = results.at(sequence.id + "_parts")[variant];
    sum.correct += weight * numberOf(one["correct"]);
    sum.six += weight * numberOf(one["six"]);
    const std::vector<double> found = numbersOf(one["found"]);
    const std::vector<double> curve = numbersOf(one["curve_mm"]);
    for (size_t p = 0; p < found.size(); ++p) sum.found[p] += weight * found[p];
    for (size_t p = 0; p < curve.size(); ++p) {
      if (!std::isfinite(curve[p])) continue;
      sum.curve[p] += curve[p];
      curves[p] += 1.0;
    }
  }
  for (size_t p = 0; p < curves.size(); ++p) sum.curve[p] /= curves[p] > 0 ? curves[p] : NAN;
  return sum;
}

std::string wholePercent(double fraction) {
  return formatNumber("%.0f %%", 100.0 * fraction);
}

std::string wholeMillimetres(double mm) {
  return formatNumber("%.0f mm", mm);
}

}  // namespace markerless_mocap
