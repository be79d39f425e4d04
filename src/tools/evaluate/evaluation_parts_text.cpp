#include "tools/evaluate/evaluation_parts_text.h"

#include "tools/common/html_text.h"
#include "tools/common/number_format.h"
#include "tools/common/svg_plot.h"

namespace markerless_mocap {
namespace {

constexpr const char *kRight = "#2a9d5c", *kWrong = "#c0392b", *kRightInvalid = "#a8d5ba",
                     *kWrongInvalid = "#b9bec4";

struct NamedFigures {
  const char *name, *words;
  const PartStatistics& figures;
};

std::vector<NamedFigures> figuresOf(const PartErrors& errors) {
  return {{"all", "all frames", errors.all},
          {"free", "no lower limb touches", errors.free},
          {"touching", "one touches", errors.touching},
          {"valid", "valid", errors.valid}};
}

struct NamedCurve {
  const char* name;
  const SummaryStatistics& distance_mm;
};

std::vector<NamedCurve> curvesOf(const PartErrors& errors) {
  return {{"torso", errors.torso_mm},
          {"head", errors.head_mm},
          {"arms", errors.arms_mm},
          {"legs", errors.legs_mm}};
}

std::string statusText(const PartsEvaluation& parts) {
  std::string text;
  for (const auto& [status, count] : parts.status_counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + status;
  return text;
}

std::string figuresText(const PartStatistics& figures) {
  return formatPercent(figures.fraction_correct) + " of the voxels (worst " +
         formatPercent(figures.worst_correct) + ", " +
         formatPercent(figures.fraction_correct_inside) +
         " beyond 60 mm of a border), six parts in " + formatPercent(figures.fraction_all_six) +
         " of " + std::to_string(figures.frames);
}

std::string bandOf(const PartsEvaluation& parts, const std::vector<double>& seconds) {
  std::vector<BandCell> cells;
  for (size_t f = 0; f < seconds.size(); ++f) {
    const PartEvaluation& verdict = parts.errors.verdicts[f];
    std::string words = formatNumber("%.3f s: ", seconds[f]) +
                        (verdict.free ? "free, " : "touching, ") +
                        formatPercent(verdict.fraction_correct) + " right";
    if (!parts.reasons[f].empty()) words += ": " + parts.reasons[f];
    cells.push_back({verdict.valid ? (verdict.all_six_correct ? kRight : kWrong)
                                   : (verdict.all_six_correct ? kRightInvalid : kWrongInvalid),
                     words});
  }
  return timeBand(seconds, cells) + plotLegend({{"valid, six parts correct", kRight, {}},
                                                {"valid and wrong", kWrong, {}},
                                                {"invalid, all six correct", kRightInvalid, {}},
                                                {"invalid", kWrongInvalid, {}}});
}

}  // namespace

void printParts(const PartsEvaluation& parts, std::ostream& out) {
  out << "Body parts\n";
  printRow(out, "valid",
           formatPercent(parts.errors.fraction_valid) + "   (" + statusText(parts) + ")");
  for (const NamedFigures& kind : figuresOf(parts.errors))
    printRow(out, kind.words, figuresText(kind.figures));
  std::string curves;
  for (const NamedCurve& curve : curvesOf(parts.errors))
    curves += (curves.empty() ? "" : ", ") + std::string(curve.name) +
              formatNumber(" %.0f", curve.distance_mm.mean);
  printRow(out, "curves, mm", curves + "   (from the bones' axes)");
}

JsonObject partsObject(const PartsEvaluation& parts) {
  JsonObject out, statuses, curves;
  out.add("fraction_valid", parts.errors.fraction_valid);
  for (const auto& [status, count] : parts.status_counts) statuses.add(status, count);
  out.add("status", statuses);
  for (const NamedFigures& kind : figuresOf(parts.errors)) {
    JsonObject figures;
    figures.add("frames", kind.figures.frames);
    figures.add("fraction_correct", kind.figures.fraction_correct);
    figures.add("worst_correct", kind.figures.worst_correct);
    figures.add("fraction_correct_inside", kind.figures.fraction_correct_inside);
    figures.add("fraction_all_six", kind.figures.fraction_all_six);
    out.add(kind.name, figures);
  }
  for (const NamedCurve& curve : curvesOf(parts.errors))
    curves.add(curve.name, curve.distance_mm.mean);
  out.add("curve_mean_mm", curves);
  return out;
}

std::string partsSection(const PartsEvaluation& parts, const std::vector<double>& seconds) {
  std::string out = "<h2>Body parts</h2>\n<p>" + formatPercent(parts.errors.fraction_valid) +
                    " valid (" + escapeHtml(statusText(parts)) + ")</p>\n" +
                    bandOf(parts, seconds) + "<table>\n";
  for (const NamedFigures& kind : figuresOf(parts.errors))
    out += "<tr><td>" + std::string(kind.words) + "</td><td>" + figuresText(kind.figures) +
           "</td></tr>\n";
  for (const NamedCurve& curve : curvesOf(parts.errors))
    out += "<tr><td>curve of " + std::string(curve.name) + "</td><td>" +
           formatNumber("%.0f mm from the bones' axis", curve.distance_mm.mean) + "</td></tr>\n";
  return out + "</table>\n";
}

}  // namespace markerless_mocap
