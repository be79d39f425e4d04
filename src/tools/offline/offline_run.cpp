#include "tools/offline/offline_run.h"

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "files/whole_file.h"
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
  pipeline.makePartsOnDemand();
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

RunSummary runOffline(const OfflineOptions& options, std::ostream* notes, bool terminal) {
  RunSummary summary(!options.poses_only);
  checkFiles(options);
  Recording recording(options.input, options.recording);
  BagWriter bag(options.output);  // first, because what follows may take minutes
  if (!options.report_folder.empty()) makeReportFolder(options.report_folder);
  PersonResources resources =
      readPersonResources(options.body_id, options.urdf_template, options.body_file);
  PipelineOptions stages = options.pipeline;
  const Preparation prepared =
      options.prepared.empty()
          ? prepare(options, resources, &stages, notes, terminal)
          : readPreparation(options, options.prepared, recording.cameras().size(), &stages);
  resources.known_shape = prepared.shape;
  Pipeline pipeline(recording.rig(), resources, stages);
  pipeline.useBackgrounds(prepared.backgrounds);
  if (!options.prepared.empty() && options.recording.start > 0.0)
    settleBackgrounds(options, prepared, &pipeline);
  if (options.poses_only) pipeline.makePartsOnDemand();
  const std::shared_ptr<const TrackedBody> body = pipeline.body();
  ResultFigures figures;

  ResultWriter writer(&bag, *body->model, options.recording.world_frame,
                      makePoseFilter(body->model, stages.fitting.filter));
  Progress progress("mocap_offline", notes, terminal);
  std::optional<RunReport> report;
  if (!options.report_folder.empty())
    report.emplace(options.report_folder, *body->model, pipeline.rig(),
                   makePoseFilter(body->model, stages.fitting.filter), options.report_images);
  std::optional<CalibrationCheck> calibration;
  if (options.check_calibration) calibration.emplace(pipeline, stages.fitting);
  const auto write = [&](const FrameSet& frame_set, const PipelineResult& result) {
    if (summary.frame_sets() == 0) {
      writer.writeStaticTransforms(frame_set.stamp_ns, recording.staticTransforms());
      writer.writeDescription(frame_set.stamp_ns, body->urdf);
    }
    summary.add(result);
    if (options.masks_out) writer.writeMasks(frame_set.stamp_ns, recording.cameras(), result.masks);
    if (result.learning) return;
    figures.add(frame_set.stamp_ns, result.pose.status, result.pose.silhouette_overlap,
                result.pose.part_sigma_m);
    if (options.poses_only)
      writer.writePose(frame_set.stamp_ns, result.pose);
    else
      writer.write(frame_set.stamp_ns, result);
    if (calibration) calibration->add(frame_set, result);
    if (report) summary.addOverlaps(report->add(frame_set, result));
  };
  summary.endPreparation();
  pipeline.setStageWatch([&](const char* stage, const auto& work) { summary.timed(stage, work); });
  pipeline.processStream(
      [&] {
        std::optional<FrameSet> frame_set;
        summary.timed(RunSummary::kReading, [&] { frame_set = nextFrameSet(options, &recording); });
        progress.update(recording.fractionRead());
        return frame_set;
      },
      [&](const FrameSet& frame_set, const PipelineResult& result) {
        summary.timed(RunSummary::kWriting, [&] { write(frame_set, result); });
      });
  progress.finish();
  checkOutcome(summary, recording);
  bag.commit();
  std::vector<std::string> remarks = options.remarks;
  if (calibration) summary.setCalibrationFinding(calibration->finding());
  if (!summary.calibrationFinding().empty()) remarks.push_back(summary.calibrationFinding());
  if (report) {
    report->addBackgrounds(prepared.backgrounds, pipeline.backgrounds());
    report->write(options.input, remarks);
  }
  if (!options.save_body.empty()) saveBody(options, *body);
  figures.setCalibrationFinding(summary.calibrationFinding());
  if (!options.figures.empty()) writeWholeFile(options.figures, figures.json());
  if (notes) remarkOn(recording, *notes);
  return summary;
}

}  // namespace markerless_mocap
