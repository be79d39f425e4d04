#include "tools/evaluate/evaluation_marks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "markerless_mocap/camera/rig_file.h"
#include "tools/common/number_format.h"
#include "tools/common/result_record.h"
#include "tools/evaluate/evaluation_tree.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kLeastTolerance_ns = 1000000;

int64_t toleranceOf(const std::vector<int64_t>& stamps) {
  return std::max(kLeastTolerance_ns, int64_t(kStampTolerance * double(frameTime(stamps))));
}

/// Frames whose points of some names fit better with left and right exchanged.
size_t countExchanged(const JointTrack& real, const JointTrack& found,
                      const std::vector<std::string>& names) {
  size_t count = 0;
  for (size_t f = 0; f < real.frames(); ++f) {
    double as_is = 0.0, other = 0.0;
    for (const std::string& name : names) {
      const Eigen::Vector3d truth = real.positions[f].col(real.indexOf(name));
      const double distance = (truth - found.positions[f].col(found.indexOf(name))).norm();
      const double distance_other =
          (truth - found.positions[f].col(found.indexOf(otherSide(name)))).norm();
      if (!std::isfinite(distance) || !std::isfinite(distance_other)) continue;
      as_is += distance;
      other += distance_other;
    }
    if (other < as_is) ++count;
  }
  return count;
}

/// The points of a result at the stamps of the marks: a frame without a pose is missing.
JointTrack atMarks(const JointTrack& marks, const ResultRecord& results) {
  std::vector<int64_t> stamps;
  for (const ResultFrame& frame : results.frames) stamps.push_back(frame.stamp_ns);
  const auto match = matchStamps(marks.stamps_ns, stamps, toleranceOf(stamps));
  if (std::all_of(match.begin(), match.end(), [](int index) { return index < 0; }))
    throw std::runtime_error("no marked time is in the results");
  JointTrack out;
  out.names = marks.names;
  const JointTrack found = results.joints.select(marks.names);
  for (size_t f = 0; f < match.size(); ++f) {
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Constant(3, long(marks.names.size()), NAN);
    if (match[f] >= 0) {
      const auto at = std::lower_bound(found.stamps_ns.begin(), found.stamps_ns.end(),
                                       stamps[size_t(match[f])]);
      if (at != found.stamps_ns.end() && *at == stamps[size_t(match[f])])
        points = found.positions[size_t(at - found.stamps_ns.begin())];
    }
    out.add(marks.stamps_ns[f], points);
  }
  return out;
}

void judgePose(const JointTrack& real, const JointTrack& found, MarksEvaluation* out) {
  const auto distances = markerDistances(real, found);
  std::vector<double> D;
  for (size_t f = 0; f < real.frames(); ++f) {
    std::vector<double> frame;
    for (const auto& of_name : distances) frame.push_back(of_name[f]);
    const SummaryStatistics spread = summaryStatistics(frame);
    if (spread.count > 0) D.push_back(spread.mean);
  }
  out->frames_with_pose = D.size();
  out->D_mm = summaryStatistics(D);
  for (size_t i = 0; i < real.names.size(); ++i) {
    const SummaryStatistics spread = summaryStatistics(distances[i]);
    if (spread.count == 0) continue;
    out->names.push_back(real.names[i]);
    out->errors_mm.push_back(spread);
  }
  out->arms_exchanged =
      countExchanged(real, found, {"l_elbow", "l_wrist", "l_hand", "r_elbow", "r_wrist", "r_hand"});
  out->legs_exchanged =
      countExchanged(real, found, {"l_knee", "l_ankle", "l_foot", "r_knee", "r_ankle", "r_foot"});
}

/// Where tips are not marked, knuckles, balls of the feet and the head's centre stand for them.
JointTrack withTips(JointTrack track) {
  for (const auto& [tip, point] : {std::pair<const char*, const char*>{"head_top", "head"},
                                   {"l_hand_tip", "l_hand"},
                                   {"r_hand_tip", "r_hand"},
                                   {"l_foot_tip", "l_foot"},
                                   {"r_foot_tip", "r_foot"}})
    for (Eigen::Matrix3Xd& points : track.positions)
      if (!points.col(track.indexOf(tip)).allFinite())
        points.col(track.indexOf(tip)) = points.col(track.indexOf(point)).eval();
  return track;
}

LabelErrors judgeTrees(const JointTrack& real, const TreeRecord& trees) {
  std::vector<LabelledExtremities> labels;
  for (const int index : matchStamps(real.stamps_ns, trees.stamps_ns, toleranceOf(trees.stamps_ns)))
    labels.push_back(index < 0 ? LabelledExtremities() : trees.labels[size_t(index)]);
  return labelErrors(withTips(real).select(labelTruthNames()), labels);
}

Json spreadJson(const SummaryStatistics& spread) {
  return {{"count", spread.count}, {"mean", spread.mean}, {"max", spread.max}};
}

}  // namespace

MarksEvaluation evaluateMarks(const std::string& results, const std::string& body_id,
                              const std::string& marks_path, const std::string& rig_path) {
  const MarksFile marks = readMarks(marks_path);
  CameraRig rig;
  for (const CameraCalibration& camera : readRig(rig_path)) rig.emplace_back(camera);
  const TreeRecord trees = readTrees(results);
  MarksEvaluation out;
  std::optional<ResultRecord> record;
  try {
    record = readResults(results, body_id);
  } catch (const std::runtime_error& error) {
    if (trees.stamps_ns.empty()) throw;
    out.note = error.what();
  }
  if (record && record->frames.empty()) throw std::runtime_error(results + " has no frames");
  const int64_t first = record ? record->frames.front().stamp_ns : trees.stamps_ns.front();
  const int64_t start = std::isfinite(marks.start_s) ? std::llround(marks.start_s * 1e9) : first;
  out.marks = triangulated(marks, rig, start);
  out.frames = out.marks.joints.frames();
  if (record) judgePose(out.marks.joints, atMarks(out.marks.joints, *record), &out);
  if (!trees.stamps_ns.empty()) out.labels = judgeTrees(out.marks.joints, trees);
  return out;
}

void printMarks(const MarksEvaluation& evaluation, std::ostream& out) {
  const MarkedTrack& marks = evaluation.marks;
  out << "Marks\n";
  printRow(out, "used",
           std::to_string(marks.marks) + " in " + std::to_string(evaluation.frames) +
               " frames; from the points that their rays meet " +
               formatNumber("%.1f px", marks.residual_rms_px) + " (root mean square), " +
               formatNumber("%.1f", marks.residual_max_px) + " at most");
  printRow(out, "their own error",
           "about " + formatNumber("%.0f mm", marks.sigma_mm) +
               ", with that of the calibration: smaller differences say nothing");
  for (const std::string& sentence : marks.disagreements) out << "  left out: " << sentence << '\n';
  out << "Pose against marks, mm\n";
  if (!evaluation.note.empty()) printRow(out, "no pose", evaluation.note);
  printRow(
      out, "frames with a pose",
      std::to_string(evaluation.frames_with_pose) + " of " + std::to_string(evaluation.frames));
  printRow(out, "mean / max",
           formatNumber("%.0f", evaluation.D_mm.mean) + " / " +
               formatNumber("%.0f", evaluation.D_mm.max));
  printRow(out, "sides exchanged",
           "arms in " + std::to_string(evaluation.arms_exchanged) + " frames, legs in " +
               std::to_string(evaluation.legs_exchanged));
  for (size_t i = 0; i < evaluation.names.size(); ++i)
    printRow(out, evaluation.names[i],
             formatNumber("%.0f", evaluation.errors_mm[i].mean) + " / " +
                 formatNumber("%.0f", evaluation.errors_mm[i].max) + "   in " +
                 std::to_string(evaluation.errors_mm[i].count));
  if (!evaluation.labels) return;
  const LabelErrors& labels = *evaluation.labels;
  out << "Pose tree against marks, " << labels.frames << " frames with all five extremities\n";
  printRow(out, "valid", formatPercent(labels.fraction_valid));
  printRow(out, "labels correct",
           formatPercent(labels.fraction_correct) + "   (" +
               formatPercent(labels.fraction_kinds_correct) + " except for the sides)");
  printRow(out, "wrong but valid", formatPercent(labels.fraction_wrong_but_valid));
  for (const ExtremityLabelError& end : labels.ends)
    printRow(out, end.name,
             formatPercent(end.fraction_correct) + " of the valid, " +
                 formatNumber("%.0f mm", end.error_mm.mean));
}

std::string marksJson(const MarksEvaluation& evaluation) {
  const MarkedTrack& marks = evaluation.marks;
  Json out{{"frames", evaluation.frames},
           {"frames_with_pose", evaluation.frames_with_pose},
           {"marks", marks.marks},
           {"residual_rms_px", marks.residual_rms_px},
           {"residual_max_px", marks.residual_max_px},
           {"marks_error_mm", marks.sigma_mm},
           {"left_out", marks.disagreements},
           {"D", spreadJson(evaluation.D_mm)},
           {"arms_exchanged", evaluation.arms_exchanged},
           {"legs_exchanged", evaluation.legs_exchanged}};
  for (size_t i = 0; i < evaluation.names.size(); ++i)
    out["per_point"][evaluation.names[i]] = spreadJson(evaluation.errors_mm[i]);
  if (evaluation.labels) {
    const LabelErrors& labels = *evaluation.labels;
    out["pose_tree"] = {{"frames", labels.frames},
                        {"fraction_valid", labels.fraction_valid},
                        {"fraction_correct", labels.fraction_correct},
                        {"fraction_kinds_correct", labels.fraction_kinds_correct},
                        {"fraction_wrong_but_valid", labels.fraction_wrong_but_valid}};
    for (const ExtremityLabelError& end : labels.ends)
      out["pose_tree"]["per_end"][end.name] = {{"fraction_correct", end.fraction_correct},
                                               {"mean", end.error_mm.mean}};
  }
  return jsonText(out) + "\n";
}

}  // namespace markerless_mocap
