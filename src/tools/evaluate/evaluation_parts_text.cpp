#include "tools/evaluate/evaluation_parts_text.h"

#include "text/joined.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

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

std::string figuresText(const PartStatistics& figures) {
  return formatPercent(figures.fraction_correct) + " of the voxels (worst " +
         formatPercent(figures.worst_correct) + ", " +
         formatPercent(figures.fraction_correct_inside) +
         " beyond 60 mm of a border), six parts in " + formatPercent(figures.fraction_all_six) +
         " of " + std::to_string(figures.frames);
}

Band bandOf(const PartsEvaluation& parts) {
  Band band{"", {}};
  for (size_t f = 0; f < parts.errors.verdicts.size(); ++f) {
    const PartEvaluation& verdict = parts.errors.verdicts[f];
    std::string words = (verdict.free ? "free, " : "touching, ") +
                        formatPercent(verdict.fraction_correct) + " right";
    if (!parts.reasons[f].empty()) words += ": " + parts.reasons[f];
    band.cells.push_back({size_t(!verdict.valid) * 2 + size_t(!verdict.all_six_correct), words});
  }
  return band;
}

}  // namespace

void printParts(const PartsEvaluation& parts, std::ostream& out) {
  out << "Body parts\n";
  printRow(out, "valid",
           formatPercent(parts.errors.fraction_valid) + "   (" + formatCounts(parts.status_counts) +
               ")");
  for (const NamedFigures& kind : figuresOf(parts.errors))
    printRow(out, kind.words, figuresText(kind.figures));
  const std::string curves = joined(curvesOf(parts.errors), [](const NamedCurve& curve) {
    return std::string(curve.name) + formatNumber(" %.0f", curve.distance_mm.mean);
  });
  printRow(out, "curves, mm", curves + "   (from the bones' axes)");
}

Json partsJson(const PartsEvaluation& parts) {
  Json curves;
  Json out{{"fraction_valid", parts.errors.fraction_valid}, {"status", parts.status_counts}};
  for (const NamedFigures& kind : figuresOf(parts.errors))
    out[kind.name] = {{"frames", kind.figures.frames},
                      {"fraction_correct", kind.figures.fraction_correct},
                      {"worst_correct", kind.figures.worst_correct},
                      {"fraction_correct_inside", kind.figures.fraction_correct_inside},
                      {"fraction_all_six", kind.figures.fraction_all_six}};
  for (const NamedCurve& curve : curvesOf(parts.errors))
    curves[curve.name] = curve.distance_mm.mean;
  out["curve_mean_mm"] = curves;
  return out;
}

void addParts(const PartsEvaluation& parts, Page* page) {
  page->heading("Body parts");
  page->text(formatPercent(parts.errors.fraction_valid) + " valid (" +
             formatCounts(parts.status_counts) + ")");
  page->bands({{"valid, six parts correct", "#2a9d5c"},
               {"valid and wrong", "#c0392b"},
               {"invalid, all six correct", "#a8d5ba"},
               {"invalid", "#b9bec4"}},
              {bandOf(parts)});
  std::vector<std::vector<std::string>> rows;
  for (const NamedFigures& kind : figuresOf(parts.errors))
    rows.push_back({kind.words, figuresText(kind.figures)});
  for (const NamedCurve& curve : curvesOf(parts.errors))
    rows.push_back({std::string("curve of ") + curve.name,
                    formatNumber("%.0f mm from the bones' axis", curve.distance_mm.mean)});
  page->table({"", ""}, rows);
}

}  // namespace markerless_mocap
