#include <CLI/CLI.hpp>
#include <iostream>

#include "markerless_mocap/camera/rig_file.h"
#include "tools/common/arguments.h"
#include "tools/common/progress.h"
#include "tools/common/run_tool.h"
#include "tools/import/import_recording.h"

namespace {

using namespace markerless_mocap;

struct Arguments {
  MatricesInput matrices;
  VideosInput videos;
  FilmsInput films;
  ImportOptions options;
  bool quiet = false;
};

void describeCommon(CLI::App* command, Arguments* arguments) {
  ImportOptions& options = arguments->options;
  command
      ->add_option("--scale-to-metres", options.world.scale_to_metres,
                   "metres per unit of the calibration; 0.001 for millimetres")
      ->capture_default_str();
  command
      ->add_option("--up", options.world.up, "axis of the calibration that points up: z, -z, y ...")
      ->capture_default_str();
  command->add_option("--fps", options.fps,
                      "frame sets per second; 0: the rate of the videos, 25 for images");
  command->add_option("--start-stamp", options.start_stamp, "stamp of the first frame set, s")
      ->capture_default_str();
  command->add_option("--jpeg", options.jpeg_quality,
                      "write image_raw/compressed of this quality, 1 to 100; 0: image_raw");
  command->add_option("--rig-out", options.rig_out,
                      "rig file to write, for example for mocap_offline --rig");
  command->add_flag("--quiet", arguments->quiet, "no progress and no summary");
}

CLI::App* describeMatrices(CLI::App& app, Arguments* arguments) {
  CLI::App* command = app.add_subcommand(
      "matrices", "images or masks of numbered cameras with 3x4 projection matrices");
  MatricesInput& input = arguments->matrices;
  command->add_option("output", arguments->options.output, "bag to write")->required();
  command
      ->add_option(
          "--matrices", input.matrices,
          "files with 12 numbers or an OpenCV matrix, such as 'DIR/cam%02d.xml'; %02d stands for "
          "the number of the camera")
      ->required();
  command->add_option("--images", input.images, "such as 'DIR/cam%02d_*.png', sorted by name");
  command->add_option("--masks", input.masks,
                      "such as 'DIR/silh_cam%02d_*.pbm'; white = person, value 128 = unknown");
  describeCommon(command, arguments);
  return command;
}

CLI::App* describeVideos(CLI::App& app, Arguments* arguments) {
  CLI::App* command = app.add_subcommand(
      "videos", "one folder per camera with a video and an OpenCV calibration file");
  VideosInput& input = arguments->videos;
  command->add_option("output", arguments->options.output, "bag to write")->required();
  command->add_option("folder", input.folder, "folder that contains the folders of the cameras")
      ->required();
  command->add_option("--video", input.video, "file in each folder")->capture_default_str();
  command->add_option("--background", input.background,
                      "file in each folder: video of the empty scene, used first");
  command
      ->add_option("--background-frames", input.background_frames,
                   "number of frames from the background video")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--calibration", input.calibration,
                   "file in each folder: CameraMatrix, DistortionCoeffs, Rotation, Translation")
      ->capture_default_str();
  command->add_option("--rig", input.rig,
                      "rig file in metres with z up, replaces the calibration files");
  describeCommon(command, arguments);
  return command;
}

CLI::App* describeFilms(CLI::App& app, Arguments* arguments) {
  CLI::App* command = app.add_subcommand(
      "films", "a video or a folder of images per camera, of any rates, and one calibration");
  FilmsInput& input = arguments->films;
  command->add_option("output", arguments->options.output, "bag to write")->required();
  command
      ->add_option("films", input.films,
                   "a folder with a video, a folder of images or a folder with a video for each "
                   "camera; or videos")
      ->required();
  command
      ->add_option("--calibration", input.calibration,
                   "files or folders of any format that convert_calibration reads; cameras and "
                   "films belong together by name, or by the number in it")
      ->required();
  command->add_option("--background", input.background,
                      "films of the empty room, a folder or a list as the others, used first");
  command
      ->add_option("--background-frames", input.background_frames,
                   "number of frames from the films of the empty room")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option(
      "--masks", input.masks,
      "folder with a film of masks per camera; white = person, value 128 = unknown");
  command->add_option("--times,--timestamps", input.times,
                      "table of the time of every frame, in place of the films' own: columns "
                      "cam_id and frame_time, s; timestamps.csv beside the films is used unasked");
  command->add_flag_callback(
      "--unsynchronised", [&input] { input.start = FilmStart::kApart; },
      "the films began at different times: take the offsets that fit the motion of the person "
      "best, even if they are not certain. Without it, films without times are searched for them, "
      "and believed to have begun together if they are not certain");
  command
      ->add_flag_callback(
          "--synchronised", [&input] { input.start = FilmStart::kTogether; },
          "the films began together: nothing is searched")
      ->excludes("--unsynchronised");
  command
      ->add_option("--largest-offset", input.largest_offset,
                   "between the beginnings of two films, that is searched for, s")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  describeCommon(command, arguments);
  return command;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Converts other recordings to a bag for this package.", "import_recording");
  app.require_subcommand(1);
  Arguments arguments;
  const CLI::App* matrices = describeMatrices(app, &arguments);
  const CLI::App* films = describeFilms(app, &arguments);
  describeVideos(app, &arguments);
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("import_recording", [&] {
    catchInterruptions();
    std::ostream* notes = arguments.quiet ? nullptr : &std::cerr;
    const bool terminal = isStderrTerminal();
    ImportResult result;
    if (films->parsed()) {
      arguments.films.guess_unit = films->count("--scale-to-metres") == 0;
      arguments.films.guess_up = films->count("--up") == 0;
      result = importFilms(arguments.films, arguments.options, notes, terminal);
    } else if (matrices->parsed()) {
      result = importMatrices(arguments.matrices, arguments.options, notes, terminal);
    } else {
      result = importVideos(arguments.videos, arguments.options, notes, terminal);
    }
    if (!arguments.options.rig_out.empty()) writeRig(arguments.options.rig_out, result.cameras);
    if (!notes) return;
    print(result, *notes);
    *notes << "written: " << arguments.options.output << "\nnext: " << callOf("mocap_offline")
           << ' ' << arguments.options.output << " result.bag --report report\n";
  });
}
