#include "tools/evaluate/evaluation_json.h"

#include "pages/page.h"
#include "tools/evaluate/evaluation_feet_text.h"
#include "tools/evaluate/evaluation_parts_text.h"
#include "tools/evaluate/evaluation_tree_text.h"

namespace markerless_mocap {
namespace {

Json spreadJson(const SummaryStatistics& spread) {
  return {{"count", spread.count},
          {"mean", spread.mean},
          {"median", spread.median},
          {"p95", spread.p95},
          {"max", spread.max}};
}

Json jointsJson(const JointErrors& joints) {
  Json out{{"frames", joints.frames},
           {"frames_estimated", joints.frames_estimated},
           {"fraction_without_estimate", joints.fraction_without_estimate},
           {"fraction_markers_missing", joints.fraction_markers_missing},
           {"D_mean", joints.D_spread.mean},
           {"D_median", joints.D_spread.median},
           {"D_std", joints.D_spread.deviation},
           {"D_p95", joints.D_spread.p95},
           {"D_max", joints.D_spread.max},
           {"D_mean_without_marker_bias", joints.D_mean_unbiased},
           {"D_max_without_marker_bias", joints.D_max_unbiased}};
  for (const MarkerError& marker : joints.markers) {
    const Eigen::Vector3d& offset = marker.offset_mm;
    out["per_marker_mean"][marker.name] = marker.mean_mm;
    out["per_marker_max"][marker.name] = marker.max_mm;
    out["per_marker_mean_without_bias"][marker.name] = marker.mean_unbiased_mm;
    out["per_marker_bias_in_pelvis_frame"][marker.name] = {offset.x(), offset.y(), offset.z()};
  }
  out["swap_rate"] = joints.swaps.all;
  out["swap_rate_arms"] = joints.swaps.arms;
  out["swap_rate_legs"] = joints.swaps.legs;
  return out;
}

Json statusJson(const TrackingContinuity& record) {
  Json losses = Json::array();
  for (const LossRun& run : record.losses)
    losses.push_back(
        {{"first_frame", run.first}, {"frames", run.frames}, {"seconds", run.seconds}});
  return {{"tracked", record.tracked},
          {"reinitialized", record.reinitialized},
          {"lost", record.lost},
          {"missing", record.missing},
          {"seconds_to_first_pose", record.seconds_to_first_pose},
          {"longest_loss", record.longest_loss()},
          {"frames_after_start", record.frames_after_start},
          {"fraction_without_pose_after_start", record.fraction_without_pose_after_start},
          {"losses", losses}};
}

Json extremitiesJson(const std::vector<ExtremityError>& extremities) {
  Json out = Json::object();
  for (const ExtremityError& part : extremities) {
    out[part.name + "_mean"] = part.error_mm.mean;
    out[part.name + "_max"] = part.error_mm.max;
    out[part.name + "_fraction_correct"] = part.fraction_correct;
  }
  return out;
}

Json overlapJson(const ImageMetrics& images) {
  Json mask = Json::object(), person = Json::object(), body = Json::object();
  for (size_t c = 0; c < images.mask_iou.size(); ++c) {
    mask[images.cameras[c]] = images.mask_iou[c].mean;
    person[images.cameras[c]] = images.person_iou[c].mean;
    body[images.cameras[c]] = images.body_iou[c].mean;
  }
  return {{"silhouette", mask},
          {"person", person},
          {"body", body},
          {"hull", images.hull_iou.mean},
          {"frame_sets", images.frame_sets.size()}};
}

Json framesJson(const Evaluation& evaluation) {
  Json frames = Json::array();
  for (size_t f = 0; f < evaluation.stamps_ns.size(); ++f)
    frames.push_back({double(evaluation.stamps_ns[f] - evaluation.stamps_ns.front()) * 1e-9,
                      toString(evaluation.statuses[f]), evaluation.joints.D[f]});
  return frames;
}

}  // namespace

std::string evaluationJson(const Evaluation& evaluation) {
  Json out{{"results", evaluation.request.results},
           {"truth", evaluation.request.truth},
           {"body_id", evaluation.body_id},
           {"skip", evaluation.request.skip}};
  out.update(jointsJson(evaluation.joints));
  out["status"] = statusJson(evaluation.record);
  out["delay"] = {{"seconds", evaluation.delay.seconds},
                  {"D_mean", evaluation.delay.D_now_mm},
                  {"D_mean_shifted", evaluation.delay.D_shifted_mm}};
  if (evaluation.latency_ms.count > 0) out["latency_ms"] = spreadJson(evaluation.latency_ms);
  out["hands_and_feet"] = extremitiesJson(evaluation.extremities);
  out["per_tip_mean"] = evaluation.tip_errors_mm;
  out["feet"] = feetJson(evaluation.feet);
  out["limbs_lost"] = limbsJson(evaluation.limbs);
  out["expected_errors"] = deviationsJson(evaluation.deviations);
  out["angles_deg"] = Json::object();
  for (const AngleError& angle : evaluation.angles)
    out["angles_deg"][angle.joint] = spreadJson(angle.error_deg);
  out["iou"] = overlapJson(evaluation.images);
  if (evaluation.trees) out["pose_tree"] = treesJson(*evaluation.trees);
  if (evaluation.parts) out["body_segmentation"] = partsJson(*evaluation.parts);
  out["notes"] = evaluation.notes;
  out["frame_time_status_D"] = framesJson(evaluation);
  return jsonText(out) + "\n";
}

}  // namespace markerless_mocap
