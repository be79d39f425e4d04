#include "tools/offline/self_calibration_run.h"

#include <algorithm>
#include <utility>

#include "contour/contour_urdf_converter.h"
#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/tracking/shape_file.h"
#include "ros/package_files.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxSeconds = 60.0;  // seconds of the recording
constexpr size_t kMaxFrameSets = 48;  // some thirty are left when every second one goes

// Another posture: the joints have moved by this on average. The same one seen again would only
// let the body's faults count for more.
constexpr double kOtherPosture = 0.04;  // metres

/// Keeps instants of different postures, spread over all that is added.
class PostureCollector {
 public:
  PostureCollector(const Pipeline& pipeline, const ContourOptions& contour)
      : observer_(pipeline.rig(), contour),
        conversion_(pipeline.body()->model),
        body_(pipeline.body()->sizes) {}

  void add(const PipelineResult& result) {
    if (result.pose.status == PoseStatus::kLost) return;
    const ContourPose pose = conversion_.poseOf(result.pose.T_world_body, result.pose.angles);
    const Eigen::Matrix3Xd points = body_.points(pose);
    if (postures_ > 0 && (points - last_).colwise().norm().mean() < kOtherPosture) return;
    last_ = points;
    if (postures_++ % stride_ != 0) return;
    instants_.push_back({observer_.observe(result.masks), pose});
    if (instants_.size() > kMaxFrameSets) thinOut();
  }
  const std::vector<OrientationSample>& frame_sets() const { return instants_; }

 private:
  void thinOut() {
    stride_ *= 2;
    std::vector<OrientationSample> kept;
    for (size_t i = 0; i < instants_.size(); i += 2) kept.push_back(std::move(instants_[i]));
    instants_ = std::move(kept);
  }

  ContourObserver observer_;
  ContourUrdfConverter conversion_;
  ContourBody body_;
  Eigen::Matrix3Xd last_;
  size_t postures_ = 0, stride_ = 1;
  std::vector<OrientationSample> instants_;
};

std::vector<CameraCalibration> calibrationsOf(const CameraRig& rig) {
  std::vector<CameraCalibration> calibrations;
  for (const Camera& camera : rig) calibrations.push_back(camera.calibration());
  return calibrations;
}

}  // namespace

OrientationRefinement selfCalibrate(const OfflineOptions& run, const std::string& rig_file) {
  PersonResources sources = readPersonResources(run.body_id, run.urdf_template, run.body_file);
  if (!sources.measured) measureBody(run, &sources, nullptr);
  PipelineOptions stages = run.pipeline;
  stages.fitting.method = "contour";
  stages.fitting.person.measure = false;
  RecordingOptions beginning = run.recording;
  beginning.duration = std::min(beginning.duration, kMaxSeconds);
  Recording recording(run.input, beginning);
  Pipeline pipeline(recording.rig(), sources, stages);
  const ShapeParameters sizes = pipeline.body()->sizes;
  PostureCollector collector(pipeline, stages.fitting.contour);
  pipeline.processStream(
      [&] { return nextFrameSet(run, &recording); },
      [&](const FrameSet&, const PipelineResult& result) { collector.add(result); });
  const ShapePrior prior{sources.people, statureOf(sizes), stages.fitting.person.stature_sigma};
  OrientationRefinement estimate = refineOrientationsAndShape(
      recording.rig(), stages.fitting.contour, prior, sizes, collector.frame_sets(), {});
  if (estimate.status == OrientationRefinementStatus::kCorrected)
    writeRig(rig_file, calibrationsOf(estimate.rig));
  return estimate;
}

std::vector<std::string> calibrationMessages(const OrientationRefinement& estimate,
                                             const std::string& rig_file) {
  std::vector<std::string> sentences = {"self-calibration: " + estimate.sentence()};
  if (estimate.status != OrientationRefinementStatus::kCorrected) {
    sentences.back() += "; " + rig_file + " is not written";
    return sentences;
  }
  for (const OrientationCorrection& one : estimate.corrections) sentences.push_back(one.sentence());
  sentences.push_back("the corrected rig is written to " + rig_file);
  return sentences;
}

}  // namespace markerless_mocap
