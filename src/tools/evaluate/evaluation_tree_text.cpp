#include "tools/evaluate/evaluation_tree_text.h"

#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

std::string extremityText(const SummaryStatistics& valid, const SummaryStatistics& if_right) {
  return formatNumber("%.0f mm", valid.mean) + ", 95 % " + formatNumber("%.0f", valid.p95) +
         "   (if all are correct " + formatNumber("%.0f", if_right.mean) + ", 95 % " +
         formatNumber("%.0f)", if_right.p95);
}

/// Mean error of each joint that was found, four per line.
std::string jointsText(const TreeEvaluation& trees) {
  std::string text;
  int listed = 0;
  for (size_t i = 0; i < trees.joints.size(); ++i) {
    if (trees.joint_errors_mm[i].count == 0) continue;
    if (listed > 0) text += listed % 4 == 0 ? ",\n" + std::string(18, ' ') : ", ";
    text += trees.joints[i] + formatNumber(" %.0f", trees.joint_errors_mm[i].mean);
    ++listed;
  }
  return listed == 0 ? "none found" : text;
}

BandCell cellOf(const TreeEvaluation& trees, size_t frame) {
  const LabelEvaluation& verdict = trees.labels.verdicts[frame];
  std::string words;
  for (size_t end = 0; end < kLabelledExtremityCount && !verdict.right && verdict.complete; ++end)
    if (!verdict.extremity_correct[end])
      words += (words.empty() ? "wrong: " : " ") + std::string(extremityNames()[end]);
  const std::string& reason = trees.reasons[frame];
  if (!reason.empty()) words += (words.empty() ? "" : ": ") + reason;
  return {size_t(!verdict.valid) * 2 + size_t(!verdict.right), words};
}

void addBand(const TreeEvaluation& trees, Page* page) {
  Band band{"", {}};
  for (size_t f = 0; f < trees.labels.verdicts.size(); ++f) band.cells.push_back(cellOf(trees, f));
  page->bands({{"valid and correct", "#2a9d5c"},
               {"valid and wrong", "#c0392b"},
               {"invalid, would be correct", "#a8d5ba"},
               {"invalid", "#b9bec4"}},
              {band});
}

void addTable(const TreeEvaluation& trees, Page* page) {
  std::vector<std::vector<std::string>> rows;
  const auto line = [&](const std::string& name, const std::string& right,
                        const SummaryStatistics& error) {
    rows.push_back(
        {name, right, formatNumber("%.0f", error.mean), formatNumber("%.0f", error.p95)});
  };
  for (const ExtremityLabelError& end : trees.labels.ends)
    line(end.name, formatPercent(end.fraction_correct), end.error_mm);
  for (size_t i = 0; i < trees.joints.size(); ++i)
    if (trees.joint_errors_mm[i].count > 0) line(trees.joints[i], "", trees.joint_errors_mm[i]);
  page->text("of the valid frames; ends to the middle of the head, knuckles and balls of the feet");
  page->table({"", "#correct", "#mean mm", "#95 %"}, rows);
}

void addCurve(const LabelErrors& labels, Page* page) {
  std::vector<double> thresholds;
  PlotLine precision{"precision: correct frames among those above the threshold", {}};
  PlotLine recall{"recall: correct frames above the threshold", {}};
  for (const PrecisionRecallPoint& figures : labels.by_threshold) {
    thresholds.push_back(figures.threshold);
    precision.values.push_back(figures.precision);
    recall.values.push_back(figures.recall);
  }
  page->heading("Precision and recall by the threshold of validity", 3);
  page->lines(thresholds, "", {precision, recall}, "", 1.0);
}

/// Calibration of the validity: mean validity and fraction of correct trees per bin.
void addReliability(const LabelErrors& labels, Page* page) {
  std::vector<std::vector<std::string>> rows;
  for (const ReliabilityBin& bin : labels.reliability)
    rows.push_back({std::to_string(bin.frames), formatNumber("%.2f", bin.mean_validity),
                    formatNumber("%.2f", bin.fraction_correct)});
  page->heading("Calibration of the validity", 3);
  page->table({"#frames", "#mean validity", "#correct"}, rows);
}

}  // namespace

void printTrees(const TreeEvaluation& trees, std::ostream& out) {
  const LabelErrors& labels = trees.labels;
  out << "Pose tree\n";
  printRow(out, "valid",
           formatPercent(labels.fraction_valid) + "   (" + formatCounts(trees.status_counts) + ")");
  printRow(out, "labels correct",
           formatPercent(labels.fraction_correct) + "   (" +
               formatPercent(labels.fraction_correct_and_valid) + " and valid; " +
               formatPercent(labels.fraction_kinds_correct) + " except for the sides)");
  printRow(out, "wrong but valid", formatPercent(labels.fraction_wrong_but_valid));
  printRow(out, "sides correct", formatPercent(labels.fraction_sides_correct) + " of the valid");
  printRow(out, "hands", extremityText(labels.hands_mm, labels.hands_if_correct_mm));
  printRow(out, "feet", extremityText(labels.feet_mm, labels.feet_if_correct_mm));
  printRow(out, "joints, mm", jointsText(trees));
  printRow(out, "validity",
           formatNumber("%.3f", labels.precision_recall_area) +
               " area under the precision-recall curve");
}

Json treesJson(const TreeEvaluation& trees) {
  const LabelErrors& labels = trees.labels;
  Json out{{"frames", labels.frames},
           {"fraction_valid", labels.fraction_valid},
           {"fraction_correct", labels.fraction_correct},
           {"fraction_correct_and_valid", labels.fraction_correct_and_valid},
           {"fraction_wrong_but_valid", labels.fraction_wrong_but_valid},
           {"fraction_kinds_correct", labels.fraction_kinds_correct},
           {"fraction_sides_correct", labels.fraction_sides_correct},
           {"status", trees.status_counts}};
  const auto addSpread = [&](const std::string& name, const SummaryStatistics& spread) {
    out[name + "_mean"] = spread.mean;
    out[name + "_p95"] = spread.p95;
  };
  addSpread("hand", labels.hands_mm);
  addSpread("foot", labels.feet_mm);
  addSpread("hand_if_right", labels.hands_if_correct_mm);
  addSpread("foot_if_right", labels.feet_if_correct_mm);
  for (const ExtremityLabelError& end : labels.ends)
    out["per_end_fraction_correct"][end.name] = end.fraction_correct;
  for (size_t i = 0; i < trees.joints.size(); ++i) {
    out["per_joint_mean"][trees.joints[i]] = trees.joint_errors_mm[i].mean;
    out["per_joint_frames"][trees.joints[i]] = trees.joint_errors_mm[i].count;
  }
  out["precision_recall_area"] = labels.precision_recall_area;
  out["threshold_precision_recall"] = Json::array();
  for (const PrecisionRecallPoint& figures : labels.by_threshold)
    out["threshold_precision_recall"].push_back(
        {figures.threshold, figures.precision, figures.recall});
  out["frames_validity_right"] = Json::array();
  for (const ReliabilityBin& bin : labels.reliability)
    out["frames_validity_right"].push_back({bin.frames, bin.mean_validity, bin.fraction_correct});
  return out;
}

void addTrees(const TreeEvaluation& trees, Page* page) {
  const LabelErrors& labels = trees.labels;
  page->heading("Pose tree");
  page->text(formatPercent(labels.fraction_valid) + " valid (" + formatCounts(trees.status_counts) +
             "), " + formatPercent(labels.fraction_correct) + " labelled correctly (" +
             formatPercent(labels.fraction_kinds_correct) + " except for the sides), " +
             formatPercent(labels.fraction_wrong_but_valid) +
             " wrong but valid; sides correct in " + formatPercent(labels.fraction_sides_correct) +
             " of the valid; area under the precision-recall curve " +
             formatNumber("%.3f", labels.precision_recall_area));
  addBand(trees, page);
  addTable(trees, page);
  addCurve(labels, page);
  addReliability(labels, page);
}

}  // namespace markerless_mocap
