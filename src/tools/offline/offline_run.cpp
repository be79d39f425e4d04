#include "tools/offline/offline_run.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "files/whole_file.h"
#include "markerless_mocap/region/person_mask.h"
#include "markerless_mocap/tracking/shape_file.h"
#include "ros/package_files.h"
#include "tools/common/progress.h"
#include "tools/common/result_figures.h"
#include "tools/offline/calibration_check.h"
#include "tools/offline/preparation.h"
#include "tools/offline/result_writer.h"
#include "tools/offline/run_report.h"

namespace markerless_mocap {
namespace {

void checkFiles(const OfflineOptions& options) {
  std::error_code ignored;
  if (std::filesystem::equivalent(options.input, options.output, ignored))
    throw std::runtime_error("input and output are the same file " + options.input);
  if (std::filesystem::is_directory(options.save_body, ignored))
    throw std::runtime_error("cannot write the body file " + options.save_body +
                             ": it is a folder");
}

void checkOutcome(const RunSummary& summary, const Recording& recording) {
  if (summary.frame_sets() == 0)
    throw std::runtime_error("no frame set has images of two cameras or more");
  if (summary.processed() == 0)
    throw std::runtime_error("the recording ends while the background is being learned, after " +
                             std::to_string(summary.frame_sets()) + " frame sets" +
                             (recording.hasMasks() ? "; its silhouettes need --use-masks" : ""));
}

void remarkOn(const Recording& recording, std::ostream& notes) {
  const AssemblerCounts& counts = recording.counts();
  if (counts.incomplete > 0)
    notes << counts.incomplete << " frame sets lack the image of a camera\n";
  for (const std::string& remark : recording.timingRemarks()) notes << remark << '\n';
  if (const uint64_t dropped = counts.abandoned + counts.late + counts.duplicate)
    notes << dropped
          << " images were not used: no other camera at that time, too late or duplicate\n";
  if (recording.unreadable() > 0)
    notes << recording.unreadable()
          << " images cannot be read, the first: " << recording.firstUnreadable() << '\n';
}

// A person who does not move enough in this time is not measured.
constexpr double kMaxMeasuringSeconds = 20.0;  // seconds

void saveBody(const OfflineOptions& options, const TrackedBody& body) {
  if (!body.shape_estimated)
    throw std::runtime_error("the body was not measured, " + options.save_body + " is not written");
  writeBodyFile(options.save_body, body.shape);
}

}  // namespace

std::optional<FrameSet> nextFrameSet(const OfflineOptions& options, Recording* recording) {
  if (options.interrupted())
    throw std::runtime_error("interrupted, " + options.output + " is not written");
  return recording->next();
}

void measureBody(const OfflineOptions& options, const std::vector<SharedBackground>& backgrounds,
                 PersonResources* resources, std::ostream* notes, bool terminal) {
  RecordingOptions beginning = options.recording;
  beginning.duration = std::min(beginning.duration, kMaxMeasuringSeconds);
  Recording recording(options.input, beginning);
  PipelineOptions stages = options.pipeline;
  stages.fitting.method = "contour";  // the only method that estimates the shape
  Pipeline pipeline(recording.rig(), *resources, stages);
  pipeline.useBackgrounds(backgrounds);
  pipeline.setOnDemand(Pipeline::OnDemand::kPartsAndVoxels);
  std::atomic<bool> measured = false;
  Progress progress("measuring the person", notes, terminal);
  pipeline.processStream(
      [&] {
        progress.update(recording.fractionRead());
        return measured ? std::nullopt : nextFrameSet(options, &recording);
      },
      [&](const FrameSet&, const PipelineResult& result) {
        measured = measured || (result.body && result.body->shape_estimated);
      });
  progress.finish();
  pipeline.estimateShapeNow();
  if (pipeline.body()->shape_estimated) resources->known_shape = pipeline.body()->shape;
  if (!notes) return;
  char stature[16];
  std::snprintf(stature, sizeof stature, "%.2f m", statureOf(pipeline.body()->shape));
  *notes << (resources->known_shape ? "the body has been measured: "
                                    : "the body could not be measured: ")
         << "its stature is set to " << stature << '\n';
}

namespace {

/// One recording from its first frame set to its outputs.
class OfflineRun {
 public:
  /// Learns the backgrounds and measures the person, which may take minutes.
  OfflineRun(const OfflineOptions& options, std::ostream* notes, bool terminal)
      : options_(checked(options)),
        notes_(notes),
        terminal_(terminal),
        summary_(!options.poses_only),
        recording_(options.input, options.recording),
        bag_(options.output) {  // first, because what follows may take minutes
    if (!options_.report_folder.empty()) makeReportFolder(options_.report_folder);
    prepareBody();
    pipeline_.emplace(recording_.rig(), resources_, stages_);
    pipeline_->useBackgrounds(prepared_.backgrounds);
    if (!options_.prepared.empty() && options_.recording.start > 0.0)
      settleBackgrounds(options_, prepared_, &*pipeline_);
    if (options_.poses_only)  // a report shows hulls
      pipeline_->setOnDemand(options_.report_folder.empty() ? Pipeline::OnDemand::kPartsAndVoxels
                                                            : Pipeline::OnDemand::kParts);
    pipeline_->followBack();
    body_ = pipeline_->body();
    writer_.emplace(&bag_, *body_->model, options_.recording.world_frame, makeFilter());
    if (!options_.report_folder.empty())
      report_.emplace(options_.report_folder, *body_->model, pipeline_->rig(), makeFilter(),
                      options_.report_images);
    if (options_.check_calibration) calibration_.emplace(*pipeline_, stages_.fitting);
    summary_.endPreparation();
  }

  RunSummary run() {
    follow();
    checkOutcome(summary_, recording_);
    bag_.commit();
    if (calibration_) summary_.setCalibrationFinding(calibration_->finding());
    if (report_) writeReport();
    if (!options_.save_body.empty()) saveBody(options_, *body_);
    figures_.setCalibrationFinding(summary_.calibrationFinding());
    if (!options_.figures.empty()) writeWholeFile(options_.figures, figures_.json());
    if (notes_) remarkOn(recording_, *notes_);
    return std::move(summary_);
  }

 private:
  static const OfflineOptions& checked(const OfflineOptions& options) {
    checkFiles(options);
    return options;
  }

  void prepareBody() {
    resources_ = readPersonResources(options_.body_id, options_.urdf_template, options_.body_file);
    stages_ = options_.pipeline;
    prepared_ =
        options_.prepared.empty()
            ? prepare(options_, resources_, &stages_, notes_, terminal_)
            : readPreparation(options_, options_.prepared, recording_.cameras().size(), &stages_);
    resources_.known_shape = prepared_.shape;
  }

  std::optional<PoseFilter> makeFilter() const {
    return makePoseFilter(body_->model, stages_.fitting.filter);
  }

  void follow() {
    Progress progress("mocap_offline", notes_, terminal_);
    pipeline_->setStageWatch(
        [this](const char* stage, const auto& work) { summary_.timed(stage, work); });
    pipeline_->processStream(
        [&] {
          std::optional<FrameSet> frame_set;
          summary_.timed(RunSummary::kReading,
                         [&] { frame_set = nextFrameSet(options_, &recording_); });
          progress.update(recording_.fractionRead());
          return frame_set;
        },
        [this](const FrameSet& frame_set, const PipelineResult& result) {
          summary_.timed(RunSummary::kWriting, [&] { write(frame_set, result); });
        });
    progress.finish();
  }

  void write(const FrameSet& frame_set, const PipelineResult& result) {
    const int64_t stamp_ns = frame_set.stamp_ns;
    if (summary_.frame_sets() == 0) {
      writer_->writeStaticTransforms(stamp_ns, recording_.staticTransforms());
      writer_->writeDescription(stamp_ns, body_->urdf);
    }
    summary_.add(result);
    if (options_.masks_out) writeMasks(frame_set, result);
    if (result.learning) return;
    figures_.add(stamp_ns, result.pose.status, result.pose.silhouette_overlap,
                 result.pose.part_sigma_m);
    if (options_.poses_only)
      writer_->writePose(stamp_ns, result.pose);
    else
      writer_->write(stamp_ns, result);
    if (calibration_) calibration_->add(frame_set, result);
    if (report_) summary_.addOverlaps(report_->add(frame_set, result));
  }

  void writeMasks(const FrameSet& frame_set, const PipelineResult& result) {
    const std::vector<RecordedCamera>& cameras = recording_.cameras();
    writer_->writeMasks(frame_set.stamp_ns, cameras, result.masks, "silhouette");
    if (result.learning || result.pose.status == PoseStatus::kLost) return;
    std::vector<cv::Mat> person(cameras.size());
    tbb::parallel_for(size_t(0), person.size(), [&](size_t i) {
      if (!result.masks[i].empty())
        person[i] = personMask(pipeline_->rig()[i], *result.body->model, result.pose,
                               result.masks[i], frame_set.frames[i].image);
    });
    writer_->writeMasks(frame_set.stamp_ns, cameras, person, "person");
  }

  void writeReport() {
    std::vector<std::string> remarks = options_.remarks;
    if (!summary_.calibrationFinding().empty()) remarks.push_back(summary_.calibrationFinding());
    report_->addBackgrounds(prepared_.backgrounds, pipeline_->backgrounds());
    report_->write(options_.input, remarks);
  }

  const OfflineOptions& options_;
  std::ostream* notes_;
  bool terminal_;
  RunSummary summary_;
  Recording recording_;
  BagWriter bag_;
  PersonResources resources_;
  PipelineOptions stages_;
  Preparation prepared_;
  std::optional<Pipeline> pipeline_;
  std::shared_ptr<const TrackedBody> body_;
  ResultFigures figures_;
  std::optional<ResultWriter> writer_;
  std::optional<RunReport> report_;
  std::optional<CalibrationCheck> calibration_;
};

}  // namespace

RunSummary runOffline(const OfflineOptions& options, std::ostream* notes, bool terminal) {
  return OfflineRun(options, notes, terminal).run();
}

}  // namespace markerless_mocap
