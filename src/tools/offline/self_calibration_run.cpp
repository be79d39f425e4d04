#include "tools/offline/self_calibration_run.h"

#include <algorithm>
#include <utility>

#include "contour/contour_urdf_converter.h"
#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/tracking/shape_file.h"
#include "ros/package_files.h"
#include "tools/offline/recording_backgrounds.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxSeconds = 60.0;  // seconds of the recording
constexpr size_t kMaxFrameSets = 48;  // some thirty are left after every second one is removed

// A posture differs if the mean displacement of the joints is larger than this. Repeated postures
// would only give more weight to the errors of the body shape.
constexpr double kMinPostureChange = 0.04;  // metres

/// Collects frames of different postures, distributed over the whole recording.
class PostureCollector {
 public:
  PostureCollector(const Pipeline& pipeline, const ContourOptions& contour)
      : observer_(pipeline.rig(), contour),
        conversion_(pipeline.body()->model),
        body_(pipeline.body()->shape) {}

  void add(const PipelineResult& result) {
    if (result.pose.status == PoseStatus::kLost) return;
    const ContourPose pose = conversion_.poseOf(result.pose.T_world_body, result.pose.angles);
    const Eigen::Matrix3Xd points = body_.points(pose);
    if (postures_ > 0 && (points - last_).colwise().norm().mean() < kMinPostureChange) return;
    last_ = points;
    if (postures_++ % stride_ != 0) return;
    samples_.push_back({observer_.observe(result.masks), pose});
    if (samples_.size() > kMaxFrameSets) thinOut();
  }
  const std::vector<OrientationSample>& frame_sets() const { return samples_; }

 private:
  void thinOut() {
    stride_ *= 2;
    std::vector<OrientationSample> kept;
    for (size_t i = 0; i < samples_.size(); i += 2) kept.push_back(std::move(samples_[i]));
    samples_ = std::move(kept);
  }

  ContourObserver observer_;
  ContourUrdfConverter conversion_;
  ContourBody body_;
  Eigen::Matrix3Xd last_;
  size_t postures_ = 0, stride_ = 1;
  std::vector<OrientationSample> samples_;
};

std::vector<CameraCalibration> calibrationsOf(const CameraRig& rig) {
  std::vector<CameraCalibration> calibrations;
  for (const Camera& camera : rig) calibrations.push_back(camera.calibration());
  return calibrations;
}

}  // namespace

OrientationRefinement selfCalibrate(const OfflineOptions& run, const std::string& rig_file) {
  PersonResources resources = readPersonResources(run.body_id, run.urdf_template, run.body_file);
  OfflineOptions with_backgrounds = run;
  const std::vector<SharedBackground> backgrounds =
      learnBackgrounds(run, &with_backgrounds.pipeline, nullptr);
  if (!resources.known_shape) measureBody(with_backgrounds, backgrounds, &resources, nullptr);
  PipelineOptions stages = with_backgrounds.pipeline;
  stages.fitting.method = "contour";
  stages.fitting.person.measure = false;
  RecordingOptions beginning = run.recording;
  beginning.duration = std::min(beginning.duration, kMaxSeconds);
  Recording recording(run.input, beginning);
  Pipeline pipeline(recording.rig(), resources, stages);
  pipeline.useBackgrounds(backgrounds);
  const ShapeParameters shape = pipeline.body()->shape;
  PostureCollector collector(pipeline, stages.fitting.contour);
  pipeline.processStream(
      [&] { return nextFrameSet(run, &recording); },
      [&](const FrameSet&, const PipelineResult& result) { collector.add(result); });
  const ShapePrior prior{resources.shape_statistics, statureOf(shape),
                         stages.fitting.person.stature_sigma};
  OrientationRefinement estimate = refineOrientationsAndShape(
      recording.rig(), stages.fitting.contour, prior, shape, collector.frame_sets(), {});
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
