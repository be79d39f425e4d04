#include "tools/evaluate/evaluation_table.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "tools/common/number_format.h"
#include "tools/evaluate/evaluation_feet_text.h"
#include "tools/evaluate/evaluation_parts_text.h"
#include "tools/evaluate/evaluation_tree_text.h"

namespace markerless_mocap {
namespace {

std::string padded(std::string text, size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

void printD(const JointErrors& joints, std::ostream& out) {
  const SummaryStatistics& D = joints.D_spread;
  out << "Joint error D, mm\n";
  printRow(out, "mean",
           formatNumber("%.1f", D.mean) + "   (" + formatNumber("%.1f", joints.D_mean_unbiased) +
               " without the constant offset of each joint)");
  printRow(out, "median / 95 %",
           formatNumber("%.1f", D.median) + " / " + formatNumber("%.1f", D.p95));
  printRow(out, "largest",
           formatNumber("%.1f", D.max) + "   (" + formatNumber("%.1f", joints.D_max_unbiased) +
               " without offsets)");
  printRow(out, "swapped sides",
           "all " + formatPercent(joints.swaps.all) + ", arms " + formatPercent(joints.swaps.arms) +
               ", legs " + formatPercent(joints.swaps.legs));
}

void printFrames(const Evaluation& evaluation, std::ostream& out) {
  const TrackingContinuity& record = evaluation.record;
  out << "Frames " << evaluation.joints.frames << '\n';
  printRow(out, "with a pose",
           std::to_string(evaluation.joints.frames_estimated) + "   (" +
               formatPercent(evaluation.joints.fraction_without_estimate) + " without; " +
               formatPercent(evaluation.joints.fraction_markers_missing) +
               " of the joints missing in the rest)");
  printRow(out, "status",
           std::to_string(record.tracked) + " tracked, " + std::to_string(record.reinitialized) +
               " reinitialized, " + std::to_string(record.lost) + " lost, " +
               std::to_string(record.missing) + " missing");
  printRow(out, "first pose", formatNumber("after %.2f s", record.seconds_to_first_pose));
  printRow(out, "after the start",
           formatPercent(record.fraction_without_pose_after_start) + " of " +
               std::to_string(record.frames_after_start) + " frames without a pose");
  printRow(
      out, "losses",
      std::to_string(record.losses.size()) +
          (record.losses.empty() ? ""
                                 : ", longest " + formatNumber("%.2f s", record.longest_loss())));
  const Delay& delay = evaluation.delay;
  printRow(out, "delay",
           std::isfinite(delay.seconds)
               ? formatNumber("%.0f ms", 1e3 * delay.seconds) + "   (D " +
                     formatNumber("%.1f", delay.D_now_mm) + " as is, " +
                     formatNumber("%.1f", delay.D_shifted_mm) + " after shifting the ground truth)"
               : "-");
  const SummaryStatistics& latency = evaluation.latency_ms;
  if (latency.count > 0)
    printRow(out, "latency",
             formatNumber("%.0f ms", latency.mean) + " mean, " +
                 formatNumber("%.0f ms", latency.p95) + " 95 %, " +
                 formatNumber("%.0f ms", latency.max) + " maximum");
}

void printMarkers(const JointErrors& joints, std::ostream& out) {
  double largest = 1.0;
  for (const MarkerError& marker : joints.markers)
    if (std::isfinite(marker.mean_mm)) largest = std::max(largest, marker.mean_mm);
  out << "Per joint, mm      mean  no offset     max\n";
  for (const MarkerError& marker : joints.markers) {
    const double fraction = std::isfinite(marker.mean_mm) ? marker.mean_mm / largest : 0.0;
    printRow(out, marker.name,
             padded(formatNumber("%.0f", marker.mean_mm), 5) +
                 padded(formatNumber("%.0f", marker.mean_unbiased_mm), 11) +
                 padded(formatNumber("%.0f", marker.max_mm), 8) + "  " +
                 std::string(size_t(std::lround(28 * fraction)), '#'));
  }
}

void printRest(const Evaluation& evaluation, std::ostream& out) {
  out << "Hands and feet\n";
  for (const ExtremityError& part : evaluation.extremities)
    printRow(out, part.name,
             formatNumber("%.0f mm", part.error_mm.mean) + ", right in " +
                 formatPercent(part.fraction_correct));
  if (!evaluation.angles.empty()) {
    const auto worst = std::max_element(evaluation.angles.begin(), evaluation.angles.end(),
                                        [](const AngleError& a, const AngleError& b) {
                                          return a.error_deg.mean < b.error_deg.mean;
                                        });
    std::vector<double> means;
    for (const AngleError& angle : evaluation.angles) means.push_back(angle.error_deg.mean);
    out << "Joint angles, degrees\n";
    printRow(out, "mean",
             formatNumber("%.1f", summaryStatistics(means).mean) + "   (worst " + worst->joint +
                 ", " + formatNumber("%.1f", worst->error_deg.mean) + ")");
  }
  const ImageMetrics& images = evaluation.images;
  if (images.frame_sets.empty()) return;
  out << "Overlap with the exact masks, IoU over " << images.frame_sets.size() << " frame sets\n";
  printRow(out, "silhouettes", formatNumber("%.3f", meanOfMeans(images.mask_iou)));
  printRow(out, "the person", formatNumber("%.3f", meanOfMeans(images.person_iou)));
  printRow(out, "fitted body", formatNumber("%.3f", meanOfMeans(images.body_iou)));
  printRow(out, "hull", formatNumber("%.3f", images.hull_iou.mean));
}

}  // namespace

double meanOfMeans(const std::vector<SummaryStatistics>& spreads) {
  std::vector<double> means;
  for (const SummaryStatistics& spread : spreads) means.push_back(spread.mean);
  return summaryStatistics(means).mean;
}

void printEvaluation(const Evaluation& evaluation, std::ostream& out) {
  printD(evaluation.joints, out);
  printFrames(evaluation, out);
  printMarkers(evaluation.joints, out);
  printLimbs(evaluation.limbs, out);
  printDeviations(evaluation.deviations, out);
  printFeet(evaluation.feet, out);
  printRest(evaluation, out);
  if (evaluation.trees) printTrees(*evaluation.trees, out);
  if (evaluation.parts) printParts(*evaluation.parts, out);
  for (const std::string& note : evaluation.notes) out << note << '\n';
}

}  // namespace markerless_mocap
