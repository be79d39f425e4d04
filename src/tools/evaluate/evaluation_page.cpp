#include "tools/evaluate/evaluation_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tools/common/html_text.h"
#include "tools/common/number_format.h"
#include "tools/common/svg_plot.h"
#include "tools/evaluate/evaluation_feet_text.h"
#include "tools/evaluate/evaluation_parts_text.h"
#include "tools/evaluate/evaluation_table.h"
#include "tools/evaluate/evaluation_tree_text.h"

namespace markerless_mocap {
namespace {

constexpr const char *kBlue = "#1f5fa8", *kOrange = "#e08a2c", *kGreen = "#2a9d5c";
constexpr int kBins = 40;

std::string colorOf(FrameStatus status) {
  constexpr const char* kColors[] = {"#b9bec4", "#c0392b", "#2a9d5c", "#e0a020"};
  return kColors[size_t(status)];
}

std::vector<double> secondsOf(const std::vector<int64_t>& stamps_ns) {
  std::vector<double> seconds;
  for (const int64_t stamp : stamps_ns) seconds.push_back(double(stamp - stamps_ns.front()) * 1e-9);
  return seconds;
}

std::string card(const std::string& value, const std::string& what) {
  return "<div class=\"card\"><b>" + value + "</b><span>" + what + "</span></div>";
}

std::string cards(const Evaluation& evaluation) {
  const JointErrors& joints = evaluation.joints;
  const TrackingContinuity& record = evaluation.record;
  std::string out = "<div class=\"cards\">";
  out += card(formatNumber("%.1f mm", joints.D_spread.mean), "mean joint error D");
  out += card(formatNumber("%.1f mm", joints.D_mean_unbiased), "D without constant offsets");
  out += card(formatNumber("%.1f mm", joints.D_spread.max), "maximum D of a frame");
  out += card(formatNumber("%.1f mm", joints.D_max_unbiased), "maximum D without offsets");
  out += card(formatPercent(1.0 - joints.fraction_without_estimate), "frames with a pose");
  out +=
      card(formatPercent(record.fraction_without_pose_after_start), "without one after the first");
  out += card(formatPercent(joints.fraction_markers_missing), "joints missing there");
  out += card(formatPercent(joints.swaps.all), "frames with sides swapped");
  out += card(formatNumber("%.0f ms", 1e3 * evaluation.delay.seconds), "delay of the motion");
  if (evaluation.latency_ms.count > 0)
    out += card(formatNumber("%.0f ms", evaluation.latency_ms.mean), "mean latency of /pose");
  if (!evaluation.images.frame_sets.empty())
    out +=
        card(formatNumber("%.3f", meanOfMeans(evaluation.images.body_iou)), "IoU body and masks");
  out += "</div>\n<p>" + std::to_string(joints.frames) +
         " frames: " + std::to_string(record.tracked) + " tracked, " +
         std::to_string(record.reinitialized) + " reinitialized, " + std::to_string(record.lost) +
         " lost, " + std::to_string(record.missing) + " missing; first pose after " +
         formatNumber("%.2f s", record.seconds_to_first_pose) + ", longest loss " +
         formatNumber("%.2f s", record.longest_loss()) + "</p>\n";
  for (const std::string& note : evaluation.notes) out += "<p>" + escapeHtml(note) + "</p>\n";
  return out;
}

std::string errorOverTime(const Evaluation& evaluation) {
  const std::vector<double> seconds = secondsOf(evaluation.stamps_ns);
  const std::vector<PlotSeries> lines{
      {"D", kBlue, evaluation.joints.D},
      {"D without constant offsets", kOrange, evaluation.joints.D_unbiased}};
  std::vector<BandCell> cells;
  for (size_t f = 0; f < seconds.size(); ++f)
    cells.push_back({colorOf(evaluation.statuses[f]), formatNumber("%.3f s: ", seconds[f]) +
                                                          toString(evaluation.statuses[f]) + ' ' +
                                                          evaluation.reasons[f]});
  const std::vector<PlotSeries> status_key{
      {"tracked", colorOf(FrameStatus::kTracked), {}},
      {"reinitialized", colorOf(FrameStatus::kReinitialized), {}},
      {"lost", colorOf(FrameStatus::kLost), {}},
      {"missing", colorOf(FrameStatus::kMissing), {}}};
  return "<h2>Error over time</h2>\n" + plotLegend(lines) + linePlot(seconds, lines, 0.0, "mm") +
         timeBand(seconds, cells) + plotLegend(status_key);
}

std::string errorPerJoint(const JointErrors& joints) {
  std::vector<BarRow> rows;
  std::string table =
      "<table><tr><th>joint</th><th class=n>mean</th><th class=n>without offset</th>"
      "<th class=n>maximum</th><th class=n>offset forward</th><th class=n>left</th>"
      "<th class=n>up</th></tr>\n";
  const auto cell = [](double value) {
    return "<td class=n>" + formatNumber("%.0f", value) + "</td>";
  };
  for (const MarkerError& marker : joints.markers) {
    rows.push_back({marker.name, {marker.mean_mm, marker.mean_unbiased_mm}});
    table += "<tr><td>" + marker.name + "</td>" + cell(marker.mean_mm) +
             cell(marker.mean_unbiased_mm) + cell(marker.max_mm) + cell(marker.offset_mm.x()) +
             cell(marker.offset_mm.y()) + cell(marker.offset_mm.z()) + "</tr>\n";
  }
  const std::vector<PlotSeries> key{{"mean error", kBlue, {}},
                                    {"without the joint's constant offset", kOrange, {}}};
  return "<h2>Error per joint</h2>\n" + plotLegend(key) + barChart(rows, {kBlue, kOrange}, "mm") +
         "<p>mm; offset in the pelvis frame, due to different definitions of the joint</p>\n" +
         table + "</table>\n";
}

std::string swapsAndTips(const Evaluation& evaluation) {
  const SwapRates& swaps = evaluation.joints.swaps;
  std::string out = "<h2>Sides, hands and feet</h2>\n<table>";
  const auto row = [&](const std::string& name, const std::string& value) {
    out += "<tr><td>" + name + "</td><td class=n>" + value + "</td></tr>\n";
  };
  row("frames with swapped sides", formatPercent(swaps.all));
  row("arms swapped", formatPercent(swaps.arms));
  row("legs swapped", formatPercent(swaps.legs));
  for (const ExtremityError& part : evaluation.extremities) {
    row(part.name + ", mean error", formatNumber("%.0f mm", part.error_mm.mean));
    row(part.name + ", correct within 150 mm", formatPercent(part.fraction_correct));
  }
  return out + "</table>\n";
}

std::string anglesSection(const std::vector<AngleError>& angles) {
  if (angles.empty()) return "";
  std::vector<BarRow> rows;
  for (const AngleError& angle : angles) rows.push_back({angle.joint, {angle.error_deg.mean}});
  return "<h2>Joint angles</h2>\n<p>mean absolute difference, degrees</p>\n" +
         barChart(rows, {kBlue}, "°");
}

std::string overlaps(const Evaluation& evaluation) {
  const ImageMetrics& images = evaluation.images;
  if (images.frame_sets.empty()) return "";
  std::vector<double> seconds;
  std::vector<PlotSeries> lines{
      {"silhouettes " + formatNumber("%.3f", meanOfMeans(images.mask_iou)), kOrange, {}},
      {"fitted body " + formatNumber("%.3f", meanOfMeans(images.body_iou)), kBlue, {}},
      {"hull " + formatNumber("%.3f", images.hull_iou.mean), kGreen, {}}};
  for (const FrameSetOverlap& frame_set : images.frame_sets) {
    seconds.push_back(double(frame_set.stamp_ns - evaluation.stamps_ns.front()) * 1e-9);
    lines[0].values.push_back(frame_set.mask);
    lines[1].values.push_back(frame_set.body);
    lines[2].values.push_back(frame_set.hull);
  }
  std::string table =
      "<table><tr><th>camera</th><th class=n>silhouette</th><th class=n>body</th></tr>\n";
  for (size_t c = 0; c < images.cameras.size(); ++c)
    table += "<tr><td>" + escapeHtml(images.cameras[c]) + "</td><td class=n>" +
             formatNumber("%.3f", images.mask_iou[c].mean) + "</td><td class=n>" +
             formatNumber("%.3f", images.body_iou[c].mean) + "</td></tr>\n";
  return "<h2>Overlap with the exact masks</h2>\n<p>intersection over union; the hull against the "
         "one carved from the exact masks</p>\n" +
         plotLegend(lines) + linePlot(seconds, lines, 1.0, "") + table + "</table>\n";
}

}  // namespace

std::string evaluationPage(const Evaluation& evaluation) {
  const auto fileName = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  std::string body = cards(evaluation) + errorOverTime(evaluation) +
                     errorPerJoint(evaluation.joints) +
                     "<h2>Distribution of errors</h2>\n<p>number of frames by D</p>\n" +
                     histogram(evaluation.joints.D, kBins, kBlue, "mm") + swapsAndTips(evaluation) +
                     limbsSection(evaluation.limbs, secondsOf(evaluation.stamps_ns)) +
                     deviationsSection(evaluation.deviations) +
                     feetSection(evaluation.feet, secondsOf(evaluation.stamps_ns)) +
                     overlaps(evaluation) + anglesSection(evaluation.angles);
  if (evaluation.trees) body += treesSection(*evaluation.trees, secondsOf(evaluation.stamps_ns));
  if (evaluation.parts) body += partsSection(*evaluation.parts, secondsOf(evaluation.stamps_ns));
  if (!evaluation.pictures.empty())
    body +=
        "<h2>Pictures</h2>\n<p>green: fitted body; red outline: exact mask; with their IoU</p>\n";
  for (const EvaluatedPicture& picture : evaluation.pictures)
    body += pictureTag(picture.image, picture.caption);
  return htmlPage(
      fileName(evaluation.request.results) + " against " + fileName(evaluation.request.truth),
      body);
}

}  // namespace markerless_mocap
