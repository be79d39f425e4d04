#include "tools/evaluate/evaluation_json.h"

#include "tools/evaluate/evaluation_feet_text.h"
#include "tools/evaluate/evaluation_parts_text.h"
#include "tools/evaluate/evaluation_tree_text.h"
#include "tools/evaluate/json_text.h"

namespace markerless_mocap {
namespace {

JsonObject spreadObject(const SummaryStatistics& spread) {
  JsonObject out;
  out.add("count", spread.count);
  out.add("mean", spread.mean);
  out.add("median", spread.median);
  out.add("p95", spread.p95);
  out.add("max", spread.max);
  return out;
}

void addJoints(const JointErrors& joints, JsonObject* out) {
  out->add("frames", joints.frames);
  out->add("frames_estimated", joints.frames_estimated);
  out->add("fraction_without_estimate", joints.fraction_without_estimate);
  out->add("fraction_markers_missing", joints.fraction_markers_missing);
  out->add("D_mean", joints.D_spread.mean);
  out->add("D_median", joints.D_spread.median);
  out->add("D_std", joints.D_spread.deviation);
  out->add("D_p95", joints.D_spread.p95);
  out->add("D_max", joints.D_spread.max);
  out->add("D_mean_without_marker_bias", joints.D_mean_unbiased);
  out->add("D_max_without_marker_bias", joints.D_max_unbiased);
  JsonObject means, maxima, unbiased, offsets;
  for (const MarkerError& marker : joints.markers) {
    means.add(marker.name, marker.mean_mm);
    maxima.add(marker.name, marker.max_mm);
    unbiased.add(marker.name, marker.mean_unbiased_mm);
    offsets.addList(marker.name, JsonObject::number(marker.offset_mm.x()) + ", " +
                                     JsonObject::number(marker.offset_mm.y()) + ", " +
                                     JsonObject::number(marker.offset_mm.z()));
  }
  out->add("per_marker_mean", means);
  out->add("per_marker_max", maxima);
  out->add("per_marker_mean_without_bias", unbiased);
  out->add("per_marker_bias_in_pelvis_frame", offsets);
  out->add("swap_rate", joints.swaps.all);
  out->add("swap_rate_arms", joints.swaps.arms);
  out->add("swap_rate_legs", joints.swaps.legs);
}

JsonObject statusObject(const Evaluation& evaluation) {
  const TrackingContinuity& record = evaluation.record;
  JsonObject out;
  out.add("tracked", record.tracked);
  out.add("reinitialized", record.reinitialized);
  out.add("lost", record.lost);
  out.add("missing", record.missing);
  out.add("seconds_to_first_pose", record.seconds_to_first_pose);
  out.add("longest_loss", record.longest_loss());
  out.add("frames_after_start", record.frames_after_start);
  out.add("fraction_without_pose_after_start", record.fraction_without_pose_after_start);
  std::string runs;
  for (const LossRun& run : record.losses) {
    JsonObject loss;
    loss.add("first_frame", run.first);
    loss.add("frames", run.frames);
    loss.add("seconds", run.seconds);
    runs += (runs.empty() ? "" : ", ") + loss.text();
  }
  out.addList("losses", runs);
  return out;
}

JsonObject delayObject(const Delay& delay) {
  JsonObject out;
  out.add("seconds", delay.seconds);
  out.add("D_mean", delay.D_now_mm);
  out.add("D_mean_shifted", delay.D_shifted_mm);
  return out;
}

JsonObject extremitiesObject(const Evaluation& evaluation) {
  JsonObject out;
  for (const ExtremityError& part : evaluation.extremities) {
    out.add(part.name + "_mean", part.error_mm.mean);
    out.add(part.name + "_max", part.error_mm.max);
    out.add(part.name + "_fraction_correct", part.fraction_correct);
  }
  return out;
}

JsonObject overlapObject(const ImageMetrics& images) {
  JsonObject out, mask, body;
  for (size_t c = 0; c < images.cameras.size(); ++c) {
    mask.add(images.cameras[c], images.mask_iou[c].mean);
    body.add(images.cameras[c], images.body_iou[c].mean);
  }
  out.add("silhouette", mask);
  out.add("body", body);
  out.add("hull", images.hull_iou.mean);
  out.add("frame_sets", images.frame_sets.size());
  return out;
}

std::string frameList(const Evaluation& evaluation) {
  std::string frames;
  for (size_t f = 0; f < evaluation.stamps_ns.size(); ++f) {
    if (f > 0) frames += ",\n ";
    frames +=
        "[" +
        JsonObject::number(double(evaluation.stamps_ns[f] - evaluation.stamps_ns.front()) * 1e-9) +
        ", \"" + toString(evaluation.statuses[f]) + "\", " +
        JsonObject::number(evaluation.joints.D[f]) + "]";
  }
  return frames;
}

}  // namespace

std::string evaluationJson(const Evaluation& evaluation) {
  JsonObject out, tips, angles;
  out.add("results", evaluation.request.results);
  out.add("truth", evaluation.request.truth);
  out.add("body_id", evaluation.body_id);
  out.add("skip", evaluation.request.skip);
  addJoints(evaluation.joints, &out);
  out.add("status", statusObject(evaluation));
  out.add("delay", delayObject(evaluation.delay));
  if (evaluation.latency_ms.count > 0) out.add("latency_ms", spreadObject(evaluation.latency_ms));
  out.add("hands_and_feet", extremitiesObject(evaluation));
  for (const auto& tip : evaluation.tip_errors_mm) tips.add(tip.first, tip.second);
  out.add("per_tip_mean", tips);
  out.add("feet", feetObject(evaluation.feet));
  out.add("limbs_lost", limbsObject(evaluation.limbs));
  out.add("expected_errors", deviationsObject(evaluation.deviations));
  for (const AngleError& angle : evaluation.angles)
    angles.add(angle.joint, spreadObject(angle.error_deg));
  out.add("angles_deg", angles);
  out.add("iou", overlapObject(evaluation.images));
  if (evaluation.trees) out.add("pose_tree", treesObject(*evaluation.trees));
  if (evaluation.parts) out.add("body_segmentation", partsObject(*evaluation.parts));
  std::string notes;
  for (const std::string& note : evaluation.notes)
    notes += (notes.empty() ? "" : ", ") + JsonObject::quoted(note);
  out.addList("notes", notes);
  out.addList("frame_time_status_D", frameList(evaluation));
  return out.text() + "\n";
}

}  // namespace markerless_mocap
