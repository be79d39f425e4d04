#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "files/whole_file.h"
#include "tools/check/check_recording.h"
#include "tools/common/arguments.h"
#include "tools/common/configuration.h"
#include "tools/common/progress.h"
#include "tools/common/run_tool.h"

namespace {

using namespace markerless_mocap;

constexpr int kSomethingWrong = 1, kBadInput = 2;

struct Arguments {
  CheckArguments check;
  std::string config, json;
  bool quiet = false;
};

void describe(CLI::App& app, Arguments* a) {
  app.add_option("bag", a->check.bag, "recording: images, camera_info and tf of several cameras");
  app.add_option("--json", a->json, "file to write the findings to; -: to standard output");
  app.add_option("--cameras", a->check.cameras, "names of the cameras to look at; default: all");
  app.add_option("--rig", a->check.rig, "rig file in place of camera_info and tf");
  app.add_option("--config", a->config,
                 "YAML file with the stages' options: the volume, silhouettes");
  app.add_option("--world", a->check.world_frame, "frame of the world in tf")
      ->capture_default_str();
  app.add_option("--seconds", a->check.seconds,
                 "at the beginning, in which silhouettes are looked for")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--live", a->check.live, "seconds to listen to running topics in place of a bag")
      ->check(CLI::Range(2.0, 600.0));
  app.add_flag("--repeat", a->check.repeat,
               "with --live: check again and again, into /diagnostics, until ended");
  app.add_flag("--quiet", a->quiet, "no progress");
}

void writeJson(const CheckResult& result, const std::string& path) {
  if (path == "-") {
    std::cout << jsonOf(result);
    return;
  }
  writeWholeFile(path, jsonOf(result));
}

CheckResult checkBag(const Arguments& a, const PipelineOptions& pipeline) {
  const SeenRig rig =
      readSeenRig(a.check, pipeline, a.quiet ? nullptr : &std::cerr, isStderrTerminal());
  return resultOf(rig, a.check.bag);
}

bool check(const Arguments& a) {
  if (a.check.bag.empty() == (a.check.live == 0))
    throw std::invalid_argument("give a bag, or --live and the seconds to listen");
  const PipelineOptions pipeline =
      a.config.empty() ? PipelineOptions() : readConfiguration(a.config);
  const CheckResult result =
      a.check.live > 0 ? checkLive(a.check, pipeline) : checkBag(a, pipeline);
  if (a.json != "-") print(result, std::cout);
  if (!a.json.empty()) writeJson(result, a.json);
  return !isAnythingWrong(result);
}

bool isLive(int argc, char** argv) {
  return std::any_of(argv, argv + argc,
                     [](const char* text) { return std::string(text).rfind("--live", 0) == 0; });
}

}  // namespace

int main(int argc, char** argv) {
  if (isLive(argc, argv))  // else an interruption ends the program at once
    ros::init(argc, argv, "check_recording", ros::init_options::AnonymousName);
  CLI::App app("Says what is wrong with a recording of several cameras.", "check_recording");
  app.footer(
      "Exit code: 0 nothing wrong, 1 something wrong, 2 bad input. docs/checking.md lists what "
      "may be found.");
  Arguments arguments;
  describe(app, &arguments);
  if (const auto code = parseArguments(app, argc, argv)) return *code == 0 ? 0 : kBadInput;
  bool fine = false;
  if (runTool("check_recording", [&] { fine = check(arguments); }) != 0) return kBadInput;
  return fine ? 0 : kSomethingWrong;
}
