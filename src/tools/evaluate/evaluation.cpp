#include "tools/evaluate/evaluation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <utility>

#include "evaluation/body_points.h"
#include "markerless_mocap/body/body_model.h"
#include "tools/common/configuration.h"
#include "tools/common/result_record.h"
#include "tools/common/truth_record.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxImageFrames = 120;
constexpr double kOffline_ms = 0.01;  // results whose record time equals the capture time within
                                      // this were made offline
constexpr double kReadingFraction = 0.2, kMaskFraction = 0.4;  // fractions of the whole progress

void leaveOut(double seconds, TruthRecord* truth) {
  JointTrack& joints = truth->joints;
  const int64_t begin = joints.stamps_ns.front() + int64_t(seconds * 1e9);
  const auto first = std::lower_bound(joints.stamps_ns.begin(), joints.stamps_ns.end(), begin) -
                     joints.stamps_ns.begin();
  if (size_t(first) >= joints.frames())
    throw std::runtime_error(
        "nothing is left to evaluate: the ground truth is shorter than the time to skip");
  joints.stamps_ns.erase(joints.stamps_ns.begin(), joints.stamps_ns.begin() + first);
  joints.positions.erase(joints.positions.begin(), joints.positions.begin() + first);
}

std::string seconds(int64_t ns) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", double(ns) * 1e-9);
  return text;
}

void checkOverlap(const TruthRecord& truth, const ResultRecord& results, int64_t tolerance_ns) {
  const auto& stamps = truth.joints.stamps_ns;
  const int64_t begin = stamps.front() - tolerance_ns, end = stamps.back() + tolerance_ns;
  if (results.frames.empty() || results.frames.back().stamp_ns < begin ||
      results.frames.front().stamp_ns > end)
    throw std::runtime_error(
        "ground truth and results do not overlap in time: the ground truth lasts from " +
        seconds(stamps.front()) + " s to " + seconds(stamps.back()) + " s" +
        (results.frames.empty() ? ", the results are empty"
                                : ", the results from " + seconds(results.frames.front().stamp_ns) +
                                      " s to " + seconds(results.frames.back().stamp_ns) + " s"));
}

void checkWorlds(const TruthRecord& truth, const ResultRecord& results) {
  if (!results.world_frame.empty() && results.world_frame != truth.world_frame)
    throw std::runtime_error("the results are in the frame " + results.world_frame +
                             ", the ground truth in " + truth.world_frame +
                             ": they cannot be compared");
}

std::vector<int64_t> stampsOf(const std::vector<ResultFrame>& frames) {
  std::vector<int64_t> stamps;
  for (const ResultFrame& frame : frames) stamps.push_back(frame.stamp_ns);
  return stamps;
}

std::vector<int64_t> stampsOf(const std::vector<AngleFrame>& frames) {
  std::vector<int64_t> stamps;
  for (const AngleFrame& frame : frames) stamps.push_back(frame.stamp_ns);
  return stamps;
}

void evaluateStatus(const TruthRecord& truth, const ResultRecord& results, int64_t tolerance_ns,
                    Evaluation* out) {
  const auto match = matchStamps(out->stamps_ns, stampsOf(results.frames), tolerance_ns);
  for (const int index : match) {
    const ResultFrame* frame = index < 0 ? nullptr : &results.frames[index];
    out->statuses.push_back(frame ? frame->status : FrameStatus::kMissing);
    out->reasons.push_back(frame ? frame->reason : "");
    out->frames.push_back(frame ? *frame : ResultFrame());
    out->frames.back().stamp_ns = out->stamps_ns[out->frames.size() - 1];
  }
  out->record = trackingContinuity(out->stamps_ns, out->statuses);
  std::vector<double> latencies;
  for (const double latency : results.latencies) latencies.push_back(1e3 * latency);
  out->latency_ms = summaryStatistics(latencies);
  if (!(out->latency_ms.max > kOffline_ms)) out->latency_ms.count = 0;
  out->feet = evaluateFeet(truth.joints, results, match);
  out->deviations = evaluateDeviations(truth.joints, results, match);
  if (!results.has_status)
    out->notes.push_back("There is no /pose: each transform counts as a tracked frame.");
}

void evaluateJoints(const TruthRecord& truth, const ResultRecord& results, Evaluation* out) {
  const JointTrack real = truth.joints.select(markerNames());
  const JointTrack tips = truth.joints.select(tipNames());
  const JointTrack found = alignedTo(real, results.joints);
  out->joints = jointErrors(real, found);
  out->limbs = limbLosses(real, found);
  out->delay = estimateDelay(real, results.joints);
  const JointTrack found_tips = alignedTo(tips, results.joints);
  for (const char* name : {"hand", "foot"})
    out->extremities.push_back(extremityError(tips, found_tips, name));
  const auto distances = markerDistances(tips, found_tips);
  for (size_t i = 0; i < distances.size(); ++i)
    out->tip_errors_mm[tips.names[i]] = summaryStatistics(distances[i]).mean;
  if (!results.has_description)
    out->notes.push_back(
        "The results have no human_description: hands, feet and the body's "
        "outline are not evaluated.");
}

void evaluateAngles(const TruthRecord& truth, const ResultRecord& results, int64_t tolerance_ns,
                    Evaluation* out) {
  const auto match = matchStamps(stampsOf(truth.angles), stampsOf(results.angles), tolerance_ns);
  std::vector<AngleFrame> judged;
  std::vector<int> judged_match;
  for (size_t f = 0; f < truth.angles.size(); ++f) {
    if (truth.angles[f].stamp_ns < out->stamps_ns.front()) continue;
    judged.push_back(truth.angles[f]);
    judged_match.push_back(match[f]);
  }
  out->angles = angleErrors(judged, results.angles, judged_match);
}

void evaluatePoseTrees(const TruthRecord& truth, int64_t tolerance_ns, Evaluation* out) {
  const TreeRecord trees = readTrees(out->request.results);
  if (trees.stamps_ns.empty()) return;
  out->trees = evaluateTrees(truth.joints, truth.world_frame, trees, tolerance_ns);
}

void evaluateBodyParts(const TruthRecord& truth, int64_t tolerance_ns, Evaluation* out) {
  const PartsRecord parts = readParts(out->request.results);
  if (parts.stamps_ns.empty()) return;
  out->parts = evaluateParts(truth.joints, truth.world_frame, parts, tolerance_ns);
}

std::vector<int64_t> imageFrameStamps(const Evaluation& evaluation) {
  const size_t stride = 1 + (evaluation.stamps_ns.size() - 1) / kMaxImageFrames;
  std::vector<int64_t> stamps;
  for (size_t f = 0; f < evaluation.stamps_ns.size(); f += stride)
    stamps.push_back(evaluation.stamps_ns[f]);
  for (const auto& frame : representativeFrames(evaluation.joints.D))
    stamps.push_back(evaluation.stamps_ns[frame.second]);
  std::sort(stamps.begin(), stamps.end());
  stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
  return stamps;
}

void evaluateImages(const ResultRecord& results, int64_t tolerance_ns,
                    const std::function<void(double)>& progress, Evaluation* out) {
  std::optional<ImageEvaluator> judge;
  try {
    judge.emplace(out->request.truth, out->request.rig, out->request.results, results,
                  imageFrameStamps(*out), tolerance_ns);
  } catch (const std::exception& error) {  // joints can be evaluated without cameras
    if (!out->request.rig.empty()) throw;
    out->notes.push_back(std::string("Silhouettes and hull are not evaluated: ") + error.what() +
                         ".");
    return;
  }
  progress(kMaskFraction);
  HullOptions rules;
  if (!out->request.config.empty()) rules = readConfiguration(out->request.config).hull;
  if (judge->hasTrueMasks())
    out->images = judge->measure(rules, [&](double fraction) {
      progress(kMaskFraction + fraction * (0.9 - kMaskFraction));
    });
  else
    out->notes.push_back(
        "Silhouettes and hull are not evaluated: the ground truth has no exact masks.");
  if (out->request.page) judge->show(out->stamps_ns, &out->shown);
}

}  // namespace

std::vector<std::pair<const char*, size_t>> representativeFrames(const std::vector<double>& D) {
  std::vector<size_t> order;
  for (size_t f = 0; f < D.size(); ++f)
    if (std::isfinite(D[f])) order.push_back(f);
  if (order.empty()) return {};
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return D[a] < D[b]; });
  return {{"worst", order.back()}, {"median", order[order.size() / 2]}, {"best", order.front()}};
}

Evaluation evaluate(const EvaluationRequest& request, const std::function<void(double)>& progress) {
  TruthRecord truth = readTruth(request.truth);
  const ResultRecord results = readResults(request.results, request.body_id);
  progress(kReadingFraction);
  checkWorlds(truth, results);
  leaveOut(request.skip, &truth);
  const auto tolerance = int64_t(kStampTolerance * double(frameTime(truth.joints.stamps_ns)));
  checkOverlap(truth, results, tolerance);

  Evaluation out;
  out.request = request;
  out.body_id = results.body_id;
  out.body = results.body;
  out.has_description = results.has_description;
  out.stamps_ns = truth.joints.stamps_ns;
  out.truth = truth.joints.select(bodyPointNames());
  evaluateStatus(truth, results, tolerance, &out);
  evaluateJoints(truth, results, &out);
  evaluateAngles(truth, results, tolerance, &out);
  evaluatePoseTrees(truth, tolerance, &out);
  evaluateBodyParts(truth, tolerance, &out);
  if (request.page) out.shown.hulls = readHulls(request.results, out.stamps_ns, tolerance);
  if (request.images) evaluateImages(results, tolerance, progress, &out);
  progress(1.0);
  return out;
}

}  // namespace markerless_mocap
