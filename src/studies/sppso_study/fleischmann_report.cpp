#include "studies/sppso_study/fleischmann_report.h"

#include <array>
#include <numeric>

#include "tools/common/html_text.h"
#include "tools/common/number_format.h"
#include "tools/common/svg_plot.h"

namespace markerless_mocap {
namespace {

constexpr std::array<const char*, 7> kColors = {"#1f5fa8", "#e08a2c", "#2a9d5c", "#c0392b",
                                                "#7d4fa0", "#555555", "#b59a00"};

/// Mean over the runs.
template <class Value>
double meanOf(const StudyResult& result, const Value& value) {
  double sum = 0.0;
  for (const StudyRun& run : result.runs) sum += value(run);
  return sum / double(result.runs.size());
}

std::string cell(const std::string& text) {
  return "<td class=n>" + text + "</td>";
}

std::string rowsOf(const StudiedTable& studied) {
  std::string out =
      "<table><tr><th></th><th class=n>runs</th><th class=n>mean D</th><th class=n>maximum D</th>"
      "<th class=n>median of means</th><th class=n>median of maxima</th>"
      "<th class=n>legs swapped</th><th class=n>lost frames</th><th class=n>ms per "
      "frame</th></tr>\n";
  for (size_t i = 0; i < studied.results.size(); ++i) {
    const StudyResult& result = studied.results[i];
    out +=
        "<tr><td>" + escapeHtml(studied.table.variants[i].name) + "</td>" +
        cell(std::to_string(result.runs.size())) + cell(formatNumber("%.1f", result.meanError())) +
        cell(formatNumber("%.1f", result.maxError())) +
        cell(formatNumber("%.1f", result.medianMean())) +
        cell(formatNumber("%.1f", result.medianMaxError())) +
        cell(formatPercent(meanOf(result, [](const StudyRun& r) { return r.errors.swaps.legs; }))) +
        cell(formatNumber("%.1f", meanOf(result, [](const StudyRun& r) { return r.lost; }))) +
        cell(formatNumber(
            "%.1f", meanOf(result, [](const StudyRun& r) { return 1e3 * r.seconds_per_frame; }))) +
        "</tr>\n";
  }
  return out + "</table>\n";
}

/// A plot has one time axis, so each contains the variants of one frame rate.
std::string graphsOf(const StudiedTable& studied) {
  std::string out;
  std::vector<bool> drawn(studied.results.size(), false);
  for (size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i]) continue;
    std::vector<PlotSeries> lines;
    for (size_t j = i; j < drawn.size(); ++j) {
      if (studied.results[j].seconds.size() != studied.results[i].seconds.size()) continue;
      drawn[j] = true;
      lines.push_back({studied.table.variants[j].name, kColors[j % kColors.size()],
                       studied.results[j].meanOverRuns()});
    }
    out += plotLegend(lines) + linePlot(studied.results[i].seconds, lines, 0.0, "mm");
  }
  return out;
}

std::string curvesSection(const StudyReport& report) {
  const FitnessCurves& curves = report.curves;
  std::vector<double> degrees;
  for (const double offset : curves.offsets)
    degrees.push_back((offset - curves.offsets.front()) * 180.0 / M_PI);
  const std::vector<PlotSeries> lines = {{"silhouette", kColors[0], curves.silhouette},
                                         {"edge", kColors[1], curves.edge},
                                         {"both", kColors[2], curves.total}};
  return "<h2>6.10 Fitness around the true pose</h2>\n<p>Each scaled to 0 to 1, over the "
         "angle " +
         escapeHtml(report.parameter) + "; the true value is in the middle.</p>\n" +
         plotLegend(lines) + linePlot(degrees, lines, 1.0, "", "&deg;");
}

std::string timeSection(const TimeByPart& time) {
  const auto row = [&](const std::string& name, double seconds) {
    return "<tr><td>" + name + "</td>" + cell(formatNumber("%.2f", 1e3 * seconds)) +
           cell(formatPercent(seconds / time.total())) + "</tr>\n";
  };
  return "<h2>6.11 Time of a frame by part, one thread, ms</h2>\n<table>" +
         row("observation: bits, edge maps", time.observing) +
         row("kinematic tree", time.kinematics) +
         row("drawing and silhouette fitness", time.drawing_and_silhouette) +
         row("edge fitness", time.edges) + row("rest: swarm, constraints", time.rest) +
         row("total", time.total()) + "</table>\n";
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
  std::string body = "<p>" + escapeHtml(report.about) + "</p>\n";
  for (const StudiedTable& studied : report.tables)
    body += "<h2>" + escapeHtml(studied.table.id + ' ' + studied.table.title) + "</h2>\n" +
            rowsOf(studied) + graphsOf(studied);
  body += curvesSection(report) + timeSection(report.time);
  return htmlPage("Search by images: experiments", body);
}

}  // namespace markerless_mocap
