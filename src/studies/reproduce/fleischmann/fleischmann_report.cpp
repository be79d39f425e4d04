#include "studies/reproduce/fleischmann/fleischmann_report.h"

#include <algorithm>
#include <cmath>

#include "studies/reproduce/fleischmann/fleischmann_variants.h"
#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

/// Mean over the runs.
double meanOf(const VariantResults& found, const char* key) {
  double sum = 0.0;
  for (size_t r = 0; r < found.runs(); ++r)
    sum += numberOf(found.json(r)[key]) / double(found.runs());
  return sum;
}

std::vector<std::string> rowOf(const Results& results, const FleischmannVariant& variant) {
  const VariantResults found(results, variant.id);
  return {variant.name,
          mm(variant.mean),
          mm(variant.max),
          std::to_string(found.runs()),
          mm(found.mean()),
          mm(found.max()),
          mm(found.medianMax()),
          formatPercent(meanOf(found, "legs_swapped")),
          formatNumber("%.0f", 1e3 * meanOf(found, "seconds_per_frame"))};
}

/// The default method of this package.
std::vector<std::string> defaultRow(const Results& results, int fps) {
  const Json& found = results.at("default" + std::to_string(fps));
  const std::string max = mm(numberOf(found["D_max"]));
  return {"default of this package, " + std::to_string(fps) + " fps",
          "-",
          "-",
          "1",
          mm(numberOf(found["D_mean"])),
          max,
          max,
          "-",
          "-"};
}

void addTable(const Results& results, const FleischmannTable& table, Page* page) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& id : table.variants)
    rows.push_back(rowOf(results, fleischmannVariant(id)));
  if (table.id == "6.3")
    for (const int fps : {60, 20}) rows.push_back(defaultRow(results, fps));
  page->table({"", "#thesis: mean", "#thesis: maximum", "#runs", "#mean D, mm", "#maximum D, mm",
               "#median of the runs' maxima", "#legs swapped", "#ms per frame"},
              rows);
}

/// Mean and maximum over the runs, of the variants of each frame rate.
void addGraphs(const Results& results, const FleischmannTable& table, Page* page) {
  for (const int fps : {60, 20}) {
    std::vector<PlotLine> mean, most;
    std::vector<double> seconds;
    bool several = false;
    for (const std::string& id : table.variants) {
      if (fleischmannVariant(id).fps != fps) continue;
      const VariantResults found(results, id);
      seconds = found.seconds();
      several = several || found.runs() > 1;
      mean.push_back({fleischmannVariant(id).name, found.meanOverRuns()});
      most.push_back({fleischmannVariant(id).name, found.maxOverRuns()});
    }
    if (mean.empty()) continue;
    page->text(several ? "D over time, mean of the runs:" : "D over time:");
    page->lines(seconds, "s", mean, "mm");
    if (!several) continue;
    page->text("Maximum of the runs:");
    page->lines(seconds, "s", most, "mm");
  }
}

void addSingleRuns(const Results& results, Page* page) {
  for (const char* id : {"base60", "base20"}) {
    const VariantResults found(results, id);
    std::vector<PlotLine> lines;
    for (size_t r = 0; r < found.runs(); ++r)
      lines.push_back({"run " + std::to_string(r + 1), found.D(r)});
    if (found.runs() > 1) lines.push_back({"mean", found.meanOverRuns(), "black"});
    page->text("Fig. 6.5: " + fleischmannVariant(id).name);
    page->lines(found.seconds(), "s", lines, "mm");
  }
}

void addMarkers(const Results& results, Page* page) {
  page->heading("6.7 Individual markers, one run (Fig. 6.15)");
  for (const char* id : {"base20", "base60"}) {
    const VariantResults found(results, id);
    std::vector<PlotLine> lines;
    for (const char* name : {"pelvis", "l_wrist", "r_wrist", "l_ankle", "r_ankle"})
      lines.push_back({name, numbersOf(found.json(0)["markers"][name])});
    page->text(fleischmannVariant(id).name);
    page->lines(found.seconds(), "s", lines, "mm");
  }
}

}  // namespace

std::string mm(double value) {
  return formatNumber("%.1f", value);
}

void addFleischmannTables(const Results& results, Page* page) {
  for (const FleischmannTable& table : fleischmannTables()) {
    page->heading(table.id + " " + table.title);
    addTable(results, table, page);
    if (table.id == "6.3") {
      const double posed =
          1.0 - std::max(numberOf(results.at("default60")["fraction_without_estimate"]),
                         numberOf(results.at("default20")["fraction_without_estimate"]));
      page->text(
          "The default (contour) has the same silhouettes, but is given neither the first pose nor "
          "the lengths of the limbs; its D is over the frames with a pose, at least " +
          formatPercent(posed) + " of them.");
      addSingleRuns(results, page);
    } else {
      addGraphs(results, table, page);
    }
    if (table.id == "6.6") addMarkers(results, page);
  }
}

}  // namespace markerless_mocap
