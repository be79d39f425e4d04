#include <glog/logging.h>

#include <ros/init.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "tools/calibrate_rig/calibrate_rig.h"
#include "tools/common/arguments.h"
#include "tools/common/board_arguments.h"
#include "tools/common/film_times.h"
#include "tools/common/progress.h"
#include "tools/common/run_tool.h"

namespace {

using namespace markerless_mocap;

void describe(CLI::App& app, CalibrateRigArguments* a) {
  app.add_option("output", a->output,
                 "folder to write: rig.yaml, camera_info/, cameras.launch, report.html")
      ->required();
  app.add_option(
         "films", a->inputs,
         "a bag; or a folder with a folder of pictures, a folder with a video, or a video for "
         "each camera; or videos. Cameras are named after topics, folders or videos")
      ->required();
  app.add_flag("--live", a->live,
               "films are names of cameras whose images are published: says what is missing while "
               "the board is waved, until it suffices or Ctrl-C; with --floor CAMERA, the board is "
               "laid on the floor at the end. Publishes calibrate_rig/coverage");
  app.add_option("--video", a->video, "video to take from each camera's folder");
  app.add_option("--lens-pictures", a->lens_pictures,
                 "pictures of the board for the lenses only, such as close ones: as films");
  app.add_flag(
      "--separate", a->separate,
      "no two images are of one time, as pictures that were taken camera by camera; --points "
      "then gives the places");
  app.add_option(
      "--times,--timestamps", a->times,
      "table of the time of every image: columns cam_id and frame_time, s; timestamps.csv beside "
      "the films is used unasked");
  app.add_flag_callback(
      "--unsynchronised", [a] { a->start = FilmStart::kApart; },
      "the films began at different times: estimate the offset of each camera, even if it is not "
      "certain. Without it, videos that have no times are searched for it, and believed to have "
      "begun together if that is not certain");
  app.add_flag_callback(
         "--synchronised", [a] { a->start = FilmStart::kTogether; },
         "the films began together: nothing is searched")
      ->excludes("--unsynchronised");
  app.add_option("--largest-offset", a->largest_offset,
                 "between the beginnings of two films, that is searched for, s")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
}

void describeMore(CLI::App& app, CalibrateRigArguments* a) {
  app.add_option("--floor", a->floor,
                 "CAMERA:SECONDS at which the board lies on the floor (of pictures: their number, "
                 "from 0); CAMERA alone: its first view of the board. Gives the origin, z up");
  app.add_option("--floor-thickness", a->floor_thickness, "of the board that lies there, m")
      ->capture_default_str();
  app.add_option("--walk", a->walk,
                 "films in which one person walks about, by the same cameras: they give the floor, "
                 "z up; may be those of the board");
  app.add_option("--points", a->points,
                 "YAML list of known points of the scene with their pixels: they give the world");
  app.add_option(
      "--lenses", a->lenses,
      "calibration whose intrinsics are kept: a rig file, a folder of camera_info YAML, or any "
      "other format of docs/calibration_formats.md");
  app.add_option(
         "--lens", a->lens,
         "auto, none, 'k1', 'k1 k2', 'k1 k2 p1 p2', 'k1 k2 p1 p2 k3', fisheye or rational; auto: "
         "the simplest that predicts views left out")
      ->capture_default_str();
  app.add_flag("--lens-only", a->lens_only, "intrinsics only, no places");
  app.add_option("--most-images", a->most_images, "searched in each film, evenly spread")
      ->check(CLI::Range(5, 100000))
      ->capture_default_str();
  app.add_option("--world", a->world_frame, "name of the world's frame in cameras.launch")
      ->capture_default_str();
}

/// What lies beside the films and is named as other programs and make_board name it.
void useFilesBesideFilms(CalibrateRigArguments* arguments, BoardArguments* board,
                         std::ostream* notes) {
  const auto find = [&](const char* what, const std::vector<std::string>& names) {
    const std::string file = fileBesideFilms(arguments->inputs, names);
    if (notes && !file.empty()) *notes << what << file << ", which lies beside the films\n";
    return file;
  };
  if (!isBoardDescribed(*board)) {
    board->file = find("the board is that of ", {"board.yaml", "charuco.toml"});
    if (notes && board->file.empty())
      *notes << "no board is described (--board), nor lies board.yaml beside the films: looked for "
                "is the one that make_board prints if it is not told otherwise\n";
  }
  if (arguments->times.empty() && arguments->start != FilmStart::kApart)
    arguments->times = find("the times are those of ", {kTimesBesideFilms});
}

}  // namespace

int main(int argc, char** argv) {
  const bool live =
      std::any_of(argv, argv + argc, [](const char* a) { return a == std::string("--live"); });
  if (live)
    ros::init(argc, argv, "calibrate_rig",
              ros::init_options::NoSigintHandler | ros::init_options::AnonymousName);
  FLAGS_minloglevel = google::GLOG_ERROR;  // Ceres warns of steps that it then takes otherwise
  CLI::App app("Calibrates cameras from films of a board that is moved about.", "calibrate_rig");
  CalibrateRigArguments arguments;
  BoardArguments board;
  bool quiet = false;
  describe(app, &arguments);
  describeBoard(app, &board);
  describeMore(app, &arguments);
  app.add_flag("--quiet", quiet, "no progress and no summary");
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("calibrate_rig", [&] {
    std::ostream* notes = quiet ? nullptr : &std::cerr;
    if (arguments.live)
      arguments.interrupted = catchInterruptions();
    else
      useFilesBesideFilms(&arguments, &board, notes);
    arguments.board = boardOf(board);
    const RigCalibration result = calibrateFilms(arguments, notes, isStderrTerminal());
    if (notes) {
      print(result, *notes);
      *notes << nextStep(arguments) << '\n';
    }
  });
}
