#include "tools/offline/self_calibration_run.h"

#include <algorithm>

#include "camera/rig_calibrations.h"
#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/tracking/shape_file.h"
#include "ros/package_files.h"
#include "tools/offline/calibration_check.h"
#include "tools/offline/recording_backgrounds.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxSeconds = 60.0;  // seconds of the recording
}  // namespace

OrientationRefinement selfCalibrate(const OfflineOptions& run, const std::string& rig_file) {
  PersonResources resources = readPersonResources(run.body_id, run.urdf_template, run.body_file);
  OfflineOptions with_backgrounds = run;
  const std::vector<SharedBackground> backgrounds =
      learnBackgrounds(run, &with_backgrounds.pipeline, nullptr, false);
  if (!resources.known_shape)
    measureBody(with_backgrounds, backgrounds, &resources, nullptr, false);
  PipelineOptions stages = with_backgrounds.pipeline;
  stages.fitting.method = "contour";
  stages.fitting.person.measure = false;
  RecordingOptions beginning = run.recording;
  beginning.duration = std::min(beginning.duration, kMaxSeconds);
  Recording recording(run.input, beginning);
  Pipeline pipeline(recording.rig(), resources, stages);
  pipeline.useBackgrounds(backgrounds);
  pipeline.setOnDemand(Pipeline::OnDemand::kPartsAndVoxels);
  const ShapeParameters shape = pipeline.body()->shape;
  OrientationSampler sampler(pipeline.rig(), stages.fitting.contour, *pipeline.body());
  pipeline.processStream([&] { return nextFrameSet(run, &recording); },
                         [&](const FrameSet& frame_set, const PipelineResult& result) {
                           addSample(frame_set, result, &sampler);
                         });
  const ShapePrior prior{resources.shape_statistics, statureOf(shape),
                         stages.fitting.person.stature_sigma};
  OrientationRefinement estimate = refineOrientationsAndShape(
      recording.rig(), stages.fitting.contour, prior, shape, sampler.samples());
  if (estimate.status == OrientationRefinementStatus::kCorrected)
    writeRig(rig_file, calibrationsOf(estimate.rig));
  return estimate;
}

std::vector<std::string> calibrationMessages(const OrientationRefinement& estimate,
                                             const std::string& rig_file) {
  std::vector<std::string> messages = {"self-calibration: " + estimate.summary()};
  if (estimate.status != OrientationRefinementStatus::kCorrected) {
    messages.back() += "; " + rig_file + " is not written";
    return messages;
  }
  for (const OrientationCorrection& one : estimate.corrections) messages.push_back(one.summary());
  messages.push_back("the corrected rig is written to " + rig_file);
  return messages;
}

}  // namespace markerless_mocap
