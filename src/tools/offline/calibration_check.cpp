#include "tools/offline/calibration_check.h"

#include <cmath>
#include <cstdio>

#include "markerless_mocap/tracking/shape_file.h"
#include "text/joined.h"
#include "tracking/calibration_scale.h"

namespace markerless_mocap {
namespace {

// Smaller turns may come from the shape of the body, which is known to a centimetre, and cost
// little; less than these pixels is what contours cannot tell. Larger turns must stand out from
// their uncertainty, too.
constexpr double kMinTurn = 0.15 * M_PI / 180.0, kMinPixels = 1.5;
constexpr double kMinDeviations = 4.0;
constexpr size_t kSamples = 16;  // enough to notice a turn

bool isRotated(const OrientationCorrection& camera) {
  const double pixels = camera.pixels.norm();
  return camera.turn > kMinTurn && pixels > kMinPixels &&
         pixels > kMinDeviations * camera.deviation.norm();
}

std::string amountOf(const OrientationCorrection& camera) {
  char text[64];
  std::snprintf(text, sizeof text, " by %.2f degrees (%.1f px)", camera.turn * 180.0 / M_PI,
                camera.pixels.norm());
  return camera.camera + text;
}

}  // namespace

CalibrationCheck::CalibrationCheck(const Pipeline& pipeline, const TrackerOptions& options)
    : rig_(pipeline.rig()), options_(options.contour) {
  if (options.method != "contour" || !pipeline.body()->shape_estimated) return;
  body_.emplace(pipeline.body()->shape);
  sampler_.emplace(rig_, options_, *pipeline.body(), kSamples);
}

void CalibrationCheck::add(const FrameSet& frame_set, const PipelineResult& result) {
  if (sampler_) addSample(frame_set, result, &*sampler_);
}

std::string CalibrationCheck::finding() const {
  if (!sampler_) return "";
  const std::string scale = scaleFinding(statureOf(body_->shape()));
  const std::string turns =
      calibrationFinding(refineCameraOrientations(rig_, options_, *body_, sampler_->samples()));
  return scale.empty() || turns.empty() ? scale + turns : scale + '\n' + turns;
}

std::string calibrationFinding(const OrientationRefinement& estimate) {
  if (estimate.status != OrientationRefinementStatus::kCorrected) return "";
  std::string cameras;
  for (const OrientationCorrection& camera : estimate.corrections)
    if (isRotated(camera)) addWord(&cameras, amountOf(camera));
  if (cameras.empty()) return "";
  return "the calibration looks wrong: the person fits better if these cameras are rotated: " +
         cameras +
         "; it is used as it is. --self-calibrate corrected.yaml estimates the rotations and "
         "uses them";
}

void addSample(const FrameSet& frame_set, const PipelineResult& result,
               OrientationSampler* sampler) {
  if (result.pose.status == PoseStatus::kLost) return;
  std::vector<cv::Mat> images;
  for (const CameraFrame& frame : frame_set.frames) images.push_back(frame.image);
  sampler->add(images, result.masks, result.pose);
}

}  // namespace markerless_mocap
