#include "tools/evaluate/evaluation_tree_text.h"

#include "tools/common/html_text.h"
#include "tools/common/number_format.h"
#include "tools/common/svg_plot.h"

namespace markerless_mocap {
namespace {

constexpr const char *kBlue = "#1f5fa8", *kOrange = "#e08a2c";
constexpr const char *kRight = "#2a9d5c", *kWrong = "#c0392b", *kRightInvalid = "#a8d5ba",
                     *kWrongInvalid = "#b9bec4";

std::string extremityText(const SummaryStatistics& valid, const SummaryStatistics& if_right) {
  return formatNumber("%.0f mm", valid.mean) + ", 95 % " + formatNumber("%.0f", valid.p95) +
         "   (if all are correct " + formatNumber("%.0f", if_right.mean) + ", 95 % " +
         formatNumber("%.0f)", if_right.p95);
}

std::string statusText(const TreeEvaluation& trees) {
  std::string text;
  for (const auto& [status, count] : trees.status_counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + status;
  return text;
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

/// Colour and tooltip of a frame in the band over time.
BandCell cellOf(const TreeEvaluation& trees, const std::vector<double>& seconds, size_t frame) {
  const LabelEvaluation& verdict = trees.labels.verdicts[frame];
  std::string words = formatNumber("%.3f s: ", seconds[frame]) +
                      (verdict.valid ? "valid, " : "invalid, ") +
                      (verdict.right ? "right" : "wrong");
  for (size_t end = 0; end < kLabelledExtremityCount && !verdict.right && verdict.complete; ++end)
    if (!verdict.extremity_correct[end]) words += std::string(" ") + extremityNames()[end];
  if (!trees.reasons[frame].empty()) words += ": " + trees.reasons[frame];
  return {verdict.valid ? (verdict.right ? kRight : kWrong)
                        : (verdict.right ? kRightInvalid : kWrongInvalid),
          words};
}

std::string bandOf(const TreeEvaluation& trees, const std::vector<double>& seconds) {
  std::vector<BandCell> cells;
  for (size_t f = 0; f < seconds.size(); ++f) cells.push_back(cellOf(trees, seconds, f));
  return timeBand(seconds, cells) + plotLegend({{"valid and correct", kRight, {}},
                                                {"valid and wrong", kWrong, {}},
                                                {"invalid, would be correct", kRightInvalid, {}},
                                                {"invalid", kWrongInvalid, {}}});
}

std::string tableOf(const TreeEvaluation& trees) {
  std::string out =
      "<table><tr><th></th><th class=n>correct</th><th class=n>mean mm</th>"
      "<th class=n>95 %</th></tr>\n";
  const auto line = [&](const std::string& name, const std::string& right,
                        const SummaryStatistics& error) {
    out += "<tr><td>" + name + "</td><td class=n>" + right + "</td><td class=n>" +
           formatNumber("%.0f", error.mean) + "</td><td class=n>" +
           formatNumber("%.0f", error.p95) + "</td></tr>\n";
  };
  for (const ExtremityLabelError& end : trees.labels.ends)
    line(end.name, formatPercent(end.fraction_correct), end.error_mm);
  for (size_t i = 0; i < trees.joints.size(); ++i)
    if (trees.joint_errors_mm[i].count > 0) line(trees.joints[i], "", trees.joint_errors_mm[i]);
  return out + "</table>\n";
}

std::string curveOf(const LabelErrors& labels) {
  std::vector<double> thresholds;
  PlotSeries precision{"precision: correct frames among those above the threshold", kBlue, {}};
  PlotSeries recall{"recall: correct frames above the threshold", kOrange, {}};
  for (const PrecisionRecallPoint& figures : labels.by_threshold) {
    thresholds.push_back(figures.threshold);
    precision.values.push_back(figures.precision);
    recall.values.push_back(figures.recall);
  }
  return "<h3>Precision and recall by the threshold of validity</h3>\n" +
         plotLegend({precision, recall}) + linePlot(thresholds, {precision, recall}, 1.0, "", "");
}

/// Calibration of the validity: mean validity and fraction of correct trees per bin.
std::string reliabilityOf(const LabelErrors& labels) {
  std::string out =
      "<h3>Calibration of the validity</h3>\n<table><tr><th class=n>frames</th><th class=n>mean "
      "validity</th><th class=n>correct</th></tr>\n";
  for (const ReliabilityBin& bin : labels.reliability)
    out += "<tr><td class=n>" + std::to_string(bin.frames) + "</td><td class=n>" +
           formatNumber("%.2f", bin.mean_validity) + "</td><td class=n>" +
           formatNumber("%.2f", bin.fraction_correct) + "</td></tr>\n";
  return out + "</table>\n";
}

}  // namespace

void printTrees(const TreeEvaluation& trees, std::ostream& out) {
  const LabelErrors& labels = trees.labels;
  out << "Pose tree\n";
  printRow(out, "valid", formatPercent(labels.fraction_valid) + "   (" + statusText(trees) + ")");
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

JsonObject treesObject(const TreeEvaluation& trees) {
  const LabelErrors& labels = trees.labels;
  JsonObject out, statuses, ends, joints, found;
  out.add("frames", labels.frames);
  out.add("fraction_valid", labels.fraction_valid);
  out.add("fraction_correct", labels.fraction_correct);
  out.add("fraction_correct_and_valid", labels.fraction_correct_and_valid);
  out.add("fraction_wrong_but_valid", labels.fraction_wrong_but_valid);
  out.add("fraction_kinds_correct", labels.fraction_kinds_correct);
  out.add("fraction_sides_correct", labels.fraction_sides_correct);
  for (const auto& [status, count] : trees.status_counts) statuses.add(status, count);
  out.add("status", statuses);
  const auto addSpread = [&](const std::string& name, const SummaryStatistics& spread) {
    out.add(name + "_mean", spread.mean);
    out.add(name + "_p95", spread.p95);
  };
  addSpread("hand", labels.hands_mm);
  addSpread("foot", labels.feet_mm);
  addSpread("hand_if_right", labels.hands_if_correct_mm);
  addSpread("foot_if_right", labels.feet_if_correct_mm);
  for (const ExtremityLabelError& end : labels.ends) ends.add(end.name, end.fraction_correct);
  out.add("per_end_fraction_correct", ends);
  for (size_t i = 0; i < trees.joints.size(); ++i) {
    joints.add(trees.joints[i], trees.joint_errors_mm[i].mean);
    found.add(trees.joints[i], trees.joint_errors_mm[i].count);
  }
  out.add("per_joint_mean", joints);
  out.add("per_joint_frames", found);
  out.add("precision_recall_area", labels.precision_recall_area);
  std::string curve;
  for (const PrecisionRecallPoint& figures : labels.by_threshold)
    curve += (curve.empty() ? "[" : ", [") + JsonObject::number(figures.threshold) + ", " +
             JsonObject::number(figures.precision) + ", " + JsonObject::number(figures.recall) +
             "]";
  out.addList("threshold_precision_recall", curve);
  std::string bins;
  for (const ReliabilityBin& bin : labels.reliability)
    bins += (bins.empty() ? "[" : ", [") + std::to_string(bin.frames) + ", " +
            JsonObject::number(bin.mean_validity) + ", " +
            JsonObject::number(bin.fraction_correct) + "]";
  out.addList("frames_validity_right", bins);
  return out;
}

std::string treesSection(const TreeEvaluation& trees, const std::vector<double>& seconds) {
  const LabelErrors& labels = trees.labels;
  return "<h2>Pose tree</h2>\n<p>" + formatPercent(labels.fraction_valid) + " valid (" +
         escapeHtml(statusText(trees)) + "), " + formatPercent(labels.fraction_correct) +
         " labelled correctly (" + formatPercent(labels.fraction_kinds_correct) +
         " except for the sides), " + formatPercent(labels.fraction_wrong_but_valid) +
         " wrong but valid; sides correct in " + formatPercent(labels.fraction_sides_correct) +
         " of the valid; area under the precision-recall curve " +
         formatNumber("%.3f", labels.precision_recall_area) + "</p>\n" + bandOf(trees, seconds) +
         "<p>of the valid frames; ends to the middle of the head, knuckles and balls of the "
         "feet</p>\n" +
         tableOf(trees) + curveOf(labels) + reliabilityOf(labels);
}

}  // namespace markerless_mocap
