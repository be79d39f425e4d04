#include <CLI/CLI.hpp>
#include <iostream>

#include "resources/resources.h"
#include "ros/package_files.h"
#include "studies/learn_contour_body/learn_contour_body.h"
#include "tools/common/person_urdf.h"
#include "tools/common/run_tool.h"

namespace {

using markerless_mocap::LearnOptions;

/// The first line of models/contour_body.yaml.
std::string madeBy(const LearnOptions& options) {
  std::string line =
      "# Made by: rosrun markerless_mocap learn_contour_body models/contour_body.yaml";
  line += " --people " + std::to_string(options.people) + " --frames " +
          std::to_string(options.frame_sets) + " --motions";
  for (const std::string& motion : options.motions) line += ' ' + motion;
  return line + '\n';
}

}  // namespace

int main(int argc, char** argv) {
  using namespace markerless_mocap;
  CLI::App app("Learns the shape statistics of the contour body from people of the virtual studio.",
               "learn_contour_body");
  LearnOptions options;
  std::string output;
  app.add_option("output", output, "YAML file to write; replaced if it exists")->required();
  app.add_option("--people", options.people, "number of people")->capture_default_str();
  app.add_option("--frames", options.frame_sets, "number of frames per motion")
      ->capture_default_str();
  app.add_option("--motions", options.motions, "names of motions in config/motions")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return runTool("learn_contour_body", [&] {
    options.files = {humanUrdfTemplate(), packageFile("config/motions")};
    options.interrupted = catchInterruptions();
    writeText(output, madeBy(options) + learnContourBody(options, &std::cerr).text());
  });
}
