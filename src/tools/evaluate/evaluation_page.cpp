#include "tools/evaluate/evaluation_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tools/common/number_format.h"
#include "tools/common/player.h"
#include "tools/evaluate/evaluation_feet_text.h"
#include "tools/evaluate/evaluation_parts_text.h"
#include "tools/evaluate/evaluation_table.h"
#include "tools/evaluate/evaluation_tree_text.h"

namespace markerless_mocap {
namespace {

constexpr const char *kBlue = "#1f5fa8", *kOrange = "#e08a2c", *kGreen = "#2a9d5c",
                     *kRed = "#b8383d";

void addCards(const Evaluation& evaluation, Page* page) {
  const JointErrors& joints = evaluation.joints;
  const TrackingContinuity& record = evaluation.record;
  std::vector<std::pair<std::string, std::string>> cards{
      {formatNumber("%.1f mm", joints.D_spread.mean), "mean joint error D"},
      {formatNumber("%.1f mm", joints.D_mean_unbiased), "D without constant offsets"},
      {formatNumber("%.1f mm", joints.D_spread.max), "maximum D of a frame"},
      {formatNumber("%.1f mm", joints.D_max_unbiased), "maximum D without offsets"},
      {formatPercent(1.0 - joints.fraction_without_estimate), "frames with a pose"},
      {formatPercent(record.fraction_without_pose_after_start), "without one after the first"},
      {formatPercent(joints.fraction_markers_missing), "joints missing there"},
      {formatPercent(joints.swaps.all), "frames with sides swapped"},
      {formatNumber("%.0f ms", 1e3 * evaluation.delay.seconds), "delay of the motion"}};
  if (evaluation.latency_ms.count > 0)
    cards.push_back({formatNumber("%.0f ms", evaluation.latency_ms.mean), "mean latency of /pose"});
  if (!evaluation.images.frame_sets.empty())
    cards.push_back(
        {formatNumber("%.3f", meanOfMeans(evaluation.images.body_iou)), "IoU body and masks"});
  page->cards(cards);
  page->text(std::to_string(joints.frames) + " frames: " + std::to_string(record.tracked) +
             " tracked, " + std::to_string(record.reinitialized) + " reinitialized, " +
             std::to_string(record.lost) + " lost, " + std::to_string(record.missing) +
             " missing; first pose after " + formatNumber("%.2f s", record.seconds_to_first_pose) +
             ", longest loss " + formatNumber("%.2f s", record.longest_loss()));
  for (const std::string& note : evaluation.notes) page->text(note);
}

/// Representative frames, and where limbs of a pose are far from the truth.
std::vector<Json> eventsOf(const Evaluation& evaluation) {
  std::vector<Json> events;
  for (const auto& [name, frame] : representativeFrames(evaluation.joints.D))
    events.push_back({{"frame", frame},
                      {"frames", 1},
                      {"what", std::string(name) + " frame"},
                      {"why", formatNumber("D = %.0f mm", evaluation.joints.D[frame])}});
  for (const LimbLoss& limb : evaluation.limbs) {
    const auto link = size_t(evaluation.body->linkIndex(limb.end));
    const auto lost = [&](size_t f) {
      if (f >= limb.lost.size() || !limb.lost[f]) return false;
      const LinkPoses& links = evaluation.frames[f].T_world_link;
      return !links.empty() && links[link].matrix().allFinite();
    };
    for (size_t f = 0, next = 0; f < limb.lost.size(); f = next + 1) {
      for (next = f; lost(next);) ++next;
      if (next == f) continue;
      events.push_back({{"frame", f},
                        {"frames", next - f},
                        {"what", limb.limb + " far off"},
                        {"why", "its end is over 150 mm off"}});
    }
  }
  return events;
}

Json playerOf(const Evaluation& evaluation) {
  PlayerContent content;
  content.body = evaluation.body.get();
  content.shape_known = evaluation.has_description;
  content.frames = &evaluation.frames;
  content.rig = &evaluation.shown.rig;
  content.hulls = &evaluation.shown.hulls;
  content.views = &evaluation.shown.views;
  content.truth = &evaluation.truth;
  content.events = eventsOf(evaluation);
  return playerPart(content);
}

void addJoints(const JointErrors& joints, Page* page) {
  page->heading("Error over time");
  page->timeLines(
      {{"D", joints.D, kBlue}, {"D without constant offsets", joints.D_unbiased, kOrange}}, "mm");
  std::vector<std::pair<std::string, std::vector<double>>> bars;
  std::vector<std::vector<std::string>> rows;
  for (const MarkerError& marker : joints.markers) {
    bars.push_back({marker.name, {marker.mean_mm, marker.mean_unbiased_mm}});
    rows.push_back({marker.name});
    for (const double value : {marker.mean_mm, marker.mean_unbiased_mm, marker.max_mm,
                               marker.offset_mm.x(), marker.offset_mm.y(), marker.offset_mm.z()})
      rows.back().push_back(formatNumber("%.0f", value));
  }
  page->heading("Error per joint");
  page->bars({"mean error", "without the joint's constant offset"}, bars, "mm");
  page->text("mm; offset in the pelvis frame, due to different definitions of the joint");
  page->table({"joint", "#mean", "#without offset", "#maximum", "#offset forward", "#left", "#up"},
              rows);
  page->heading("Distribution of errors");
  page->text("number of frames by D");
  page->histogram(joints.D, "mm");
}

void addSwapsAndTips(const Evaluation& evaluation, Page* page) {
  const SwapRates& swaps = evaluation.joints.swaps;
  std::vector<std::vector<std::string>> rows{
      {"frames with swapped sides", formatPercent(swaps.all)},
      {"arms swapped", formatPercent(swaps.arms)},
      {"legs swapped", formatPercent(swaps.legs)}};
  for (const ExtremityError& part : evaluation.extremities) {
    rows.push_back({part.name + ", mean error", formatNumber("%.0f mm", part.error_mm.mean)});
    rows.push_back({part.name + ", correct within 150 mm", formatPercent(part.fraction_correct)});
  }
  page->heading("Sides, hands and feet");
  page->table({"", "#"}, rows);
}

void addAngleErrors(const std::vector<AngleError>& angles, Page* page) {
  if (angles.empty()) return;
  std::vector<std::pair<std::string, std::vector<double>>> rows;
  for (const AngleError& angle : angles) rows.push_back({angle.joint, {angle.error_deg.mean}});
  page->heading("Errors of the joint angles");
  page->text("mean absolute difference, degrees");
  page->bars({""}, rows, "°");
}

void addOverlaps(const Evaluation& evaluation, Page* page) {
  const ImageMetrics& images = evaluation.images;
  if (images.frame_sets.empty()) return;
  std::vector<double> seconds;
  std::vector<PlotLine> lines{
      {"silhouettes " + formatNumber("%.3f", meanOfMeans(images.mask_iou)), {}, kOrange},
      {"masks of the person " + formatNumber("%.3f", meanOfMeans(images.person_iou)), {}, kRed},
      {"fitted body " + formatNumber("%.3f", meanOfMeans(images.body_iou)), {}, kBlue},
      {"hull " + formatNumber("%.3f", images.hull_iou.mean), {}, kGreen}};
  for (const FrameSetOverlap& frame_set : images.frame_sets) {
    seconds.push_back(double(frame_set.stamp_ns - evaluation.stamps_ns.front()) * 1e-9);
    lines[0].values.push_back(frame_set.mask);
    lines[1].values.push_back(frame_set.person);
    lines[2].values.push_back(frame_set.body);
    lines[3].values.push_back(frame_set.hull);
  }
  std::vector<std::vector<std::string>> rows;
  for (size_t c = 0; c < images.cameras.size(); ++c)
    rows.push_back({images.cameras[c], formatNumber("%.3f", images.mask_iou[c].mean),
                    formatNumber("%.3f", images.person_iou[c].mean),
                    formatNumber("%.3f", images.body_iou[c].mean)});
  page->heading("Overlap with the exact masks");
  page->text("intersection over union; the hull against the one carved from the exact masks");
  page->lines(seconds, "s", lines, "", 1.0);
  page->table({"camera", "#silhouette", "#person", "#body"}, rows);
}

}  // namespace

std::string evaluationPage(const Evaluation& evaluation) {
  const auto fileName = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  Page page(fileName(evaluation.request.results) + " against " +
            fileName(evaluation.request.truth));
  addCards(evaluation, &page);
  page.add(playerOf(evaluation));
  addJoints(evaluation.joints, &page);
  addSwapsAndTips(evaluation, &page);
  addLimbs(evaluation.limbs, &page);
  addDeviations(evaluation.deviations, &page);
  addFeet(evaluation.feet, &page);
  addOverlaps(evaluation, &page);
  addAngleErrors(evaluation.angles, &page);
  if (evaluation.trees) addTrees(*evaluation.trees, &page);
  if (evaluation.parts) addParts(*evaluation.parts, &page);
  if (evaluation.has_description) addMotionPlots(*evaluation.body, evaluation.frames, &page);
  return page.html();
}

}  // namespace markerless_mocap
