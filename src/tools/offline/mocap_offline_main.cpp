#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <opencv2/core/utility.hpp>
#include <optional>
#include <stdexcept>

#include "tools/common/arguments.h"
#include "tools/common/progress.h"
#include "tools/common/run_tool.h"
#include "tools/offline/offline_run.h"
#include "tools/offline/preparation.h"
#include "tools/offline/self_calibration_run.h"

namespace {

using namespace markerless_mocap;

struct Arguments {
  OfflineOptions run;
  std::string config;
  std::string self_calibrate;  ///< rig file to write; empty: no self-calibration
  std::string prepare;         ///< folder to write; empty: a whole run
  std::optional<size_t> threads;
  std::optional<double> stature;
  bool quiet = false;
};

void describe(CLI::App& app, Arguments* arguments) {
  OfflineOptions& run = arguments->run;
  app.add_option("input", run.input, "bag with images, camera_info and tf_static")->required();
  app.add_option("output", run.output, "bag to write; replaced if it exists");
  app.add_option("--config", arguments->config, "YAML file, one section per stage");
  app.add_option("--cameras", run.recording.cameras, "use these cameras only");
  app.add_flag("--use-masks", run.recording.use_masks,
               "use the recorded <camera>/silhouette; without this option only for cameras "
               "without images");
  app.add_option("--rig", run.recording.rig, "rig file that replaces camera_info and tf");
  app.add_option("--self-calibrate", arguments->self_calibrate,
                 "refine the camera orientations with the person's silhouettes, write the "
                 "corrected rig to this file (for --rig of other runs), and use it for this run");
  app.add_option("--world", run.recording.world_frame, "frame of the results")
      ->capture_default_str();
  app.add_option("--stature", arguments->stature,
                 "body height, m; overrides the configuration; start of the shape estimate");
  app.add_option("--id", run.body_id, "id of the body")->capture_default_str();
  app.add_option("--body", run.body_file,
                 "body shape of the person, from --save-body of an earlier run");
  app.add_option("--save-body", run.save_body, "file for the estimated body shape of the person");
  app.add_option("--prepare", arguments->prepare,
                 "only learn the background and measure the person, and write both to this folder");
  app.add_option("--prepared", run.prepared,
                 "folder of --prepare of the same recording, for a part of it (--start, "
                 "--duration)");
  app.add_option("--urdf-template", run.urdf_template,
                 "URDF template, replaces that of the package");
  app.add_option("--stamp-tolerance", run.recording.stamp_tolerance,
                 "stamps closer than this belong to one frame set, s")
      ->capture_default_str();
  app.add_option("--start", run.recording.start, "start this many seconds after the first image")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--duration", run.recording.duration, "seconds to process")
      ->check(CLI::PositiveNumber);
  app.add_option("--json", run.figures, "file for the figures of the run");
  app.add_option("--threads", arguments->threads, "processor cores to use; default: all")
      ->check(CLI::PositiveNumber);
  app.add_option(
      "--report", run.report_folder,
      "folder for report.html, a page that plays the motion, and overlays of the body on "
      "the images");
  app.add_flag("!--report-without-images", run.report_images,
               "no images of the person in the report, only outlines");
  app.add_flag("--masks-out", run.masks_out,
               "also write the silhouettes, and masks of the person alone");
  app.add_flag(
      "--poses-only", run.poses_only,
      "do not write hull, body parts and pose tree, and make them only where the fit needs "
      "them, which is faster");
  app.add_flag("--quiet", arguments->quiet, "no progress and no summary");
}

/// If the calibration was corrected, the run uses the corrected rig. The messages are printed even
/// if quiet, because the calibration changes.
void calibrate(const std::string& rig_file, OfflineOptions* options) {
  const OrientationRefinement estimate = selfCalibrate(*options, rig_file);
  options->check_calibration = false;
  options->remarks = calibrationMessages(estimate, rig_file);
  for (const std::string& remark : options->remarks) std::cerr << remark << '\n';
  if (estimate.status == OrientationRefinementStatus::kCorrected) options->recording.rig = rig_file;
}

/// What was written, and how it is looked at.
std::string nextStep(const OfflineOptions& options) {
  std::string text = "written: " + options.output;
  if (!options.report_folder.empty())
    return text + "; look at " + options.report_folder + "/report.html";
  return text + "; --report FOLDER also writes a page with the body over the images";
}

/// Both pools of threads that the stages use.
std::unique_ptr<tbb::global_control> limitThreads(size_t threads) {
  cv::setNumThreads(int(threads));
  return std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                               threads);
}

void run(Arguments* arguments) {
  OfflineOptions& options = arguments->run;
  std::unique_ptr<tbb::global_control> limit;
  if (arguments->threads) limit = limitThreads(*arguments->threads);
  if (!arguments->config.empty()) options.pipeline = readConfiguration(arguments->config);
  if (arguments->stature) options.pipeline.fitting.person.stature = *arguments->stature;
  options.interrupted = catchInterruptions();
  if (!arguments->self_calibrate.empty()) calibrate(arguments->self_calibrate, &options);
  std::ostream* notes = arguments->quiet ? nullptr : &std::cerr;
  if (!arguments->prepare.empty()) {
    writePreparation(options, arguments->prepare, notes, isStderrTerminal());
    return;
  }
  if (options.output.empty()) throw std::invalid_argument("give a bag to write, or --prepare");
  const RunSummary summary = runOffline(options, notes, isStderrTerminal());
  if (notes) {
    summary.print(*notes);
    *notes << nextStep(options) << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Runs all stages over a recorded bag; no frame is dropped.", "mocap_offline");
  Arguments arguments;
  describe(app, &arguments);
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("mocap_offline", [&] { run(&arguments); });
}
