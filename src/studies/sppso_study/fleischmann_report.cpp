#include "studies/sppso_study/fleischmann_report.h"

#include <numeric>

#include "pages/page.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

/// Mean over the runs.
template <class Value>
double meanOf(const StudyResult& result, const Value& value) {
  double sum = 0.0;
  for (const StudyRun& run : result.runs) sum += value(run);
  return sum / double(result.runs.size());
}

void addRows(const StudiedTable& studied, Page* page) {
  std::vector<std::vector<std::string>> rows;
  for (size_t i = 0; i < studied.results.size(); ++i) {
    const StudyResult& result = studied.results[i];
    rows.push_back(
        {studied.table.variants[i].name, std::to_string(result.runs.size()),
         formatNumber("%.1f", result.meanError()), formatNumber("%.1f", result.maxError()),
         formatNumber("%.1f", result.medianMean()), formatNumber("%.1f", result.medianMaxError()),
         formatPercent(meanOf(result, [](const StudyRun& r) { return r.errors.swaps.legs; })),
         formatNumber("%.1f", meanOf(result, [](const StudyRun& r) { return r.lost; })),
         formatNumber(
             "%.1f", meanOf(result, [](const StudyRun& r) { return 1e3 * r.seconds_per_frame; }))});
  }
  page->table({"", "#runs", "#mean D", "#maximum D", "#median of means", "#median of maxima",
               "#legs swapped", "#lost frames", "#ms per frame"},
              rows);
}

/// A plot has one time axis, so each contains the variants of one frame rate.
void addGraphs(const StudiedTable& studied, Page* page) {
  std::vector<bool> drawn(studied.results.size(), false);
  for (size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i]) continue;
    std::vector<PlotLine> lines;
    for (size_t j = i; j < drawn.size(); ++j) {
      if (studied.results[j].seconds.size() != studied.results[i].seconds.size()) continue;
      drawn[j] = true;
      lines.push_back({studied.table.variants[j].name, studied.results[j].meanOverRuns()});
    }
    page->lines(studied.results[i].seconds, "s", lines, "mm");
  }
}

void addCurves(const StudyReport& report, Page* page) {
  const FitnessCurves& curves = report.curves;
  std::vector<double> degrees;
  for (const double offset : curves.offsets)
    degrees.push_back((offset - curves.offsets.front()) * 180.0 / M_PI);
  page->heading("6.10 Fitness around the true pose");
  page->text("Each scaled to 0 to 1, over the angle " + report.parameter +
             "; the true value is in the middle.");
  page->lines(degrees, "°",
              {{"silhouette", curves.silhouette}, {"edge", curves.edge}, {"both", curves.total}},
              "", 1.0);
}

void addTime(const TimeByPart& time, Page* page) {
  const auto row = [&](const std::string& name, double seconds) -> std::vector<std::string> {
    return {name, formatNumber("%.2f", 1e3 * seconds), formatPercent(seconds / time.total())};
  };
  page->heading("6.11 Time of a frame by part, one thread, ms");
  page->table(
      {"", "#ms", "#share"},
      {row("observation: bits, edge maps", time.observing), row("kinematic tree", time.kinematics),
       row("drawing and silhouette fitness", time.drawing_and_silhouette),
       row("edge fitness", time.edges), row("rest: swarm, constraints", time.rest),
       row("total", time.total())});
}

}  // namespace

std::string studyCsv(const std::vector<StudiedTable>& tables) {
  std::string out = "table,variant,run,mean_mm,largest_mm,legs_swapped,lost,ms_per_frame\n";
  for (const StudiedTable& studied : tables)
    for (size_t i = 0; i < studied.results.size(); ++i)
      for (size_t r = 0; r < studied.results[i].runs.size(); ++r) {
        const StudyRun& run = studied.results[i].runs[r];
        out += studied.table.id + ",\"" + studied.table.variants[i].name + "\"," +
               std::to_string(r + 1) + formatNumber(",%.2f", run.errors.D_spread.mean) +
               formatNumber(",%.2f", run.errors.D_spread.max) +
               formatNumber(",%.4f", run.errors.swaps.legs) + ',' + std::to_string(run.lost) +
               formatNumber(",%.2f", 1e3 * run.seconds_per_frame) + '\n';
      }
  return out;
}

std::string studyPage(const StudyReport& report) {
  Page page("Search by images: experiments");
  page.text(report.about);
  for (const StudiedTable& studied : report.tables) {
    page.heading(studied.table.id + ' ' + studied.table.title);
    addRows(studied, &page);
    addGraphs(studied, &page);
  }
  addCurves(report, &page);
  addTime(report.time, &page);
  return page.html();
}

}  // namespace markerless_mocap
