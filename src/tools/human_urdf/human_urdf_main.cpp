#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "tools/common/arguments.h"
#include "tools/common/configuration.h"
#include "tools/common/person_urdf.h"
#include "tools/common/run_tool.h"

namespace markerless_mocap {
namespace {

/// pose_fitting/stature of a configuration, metres.
double statureOf(const std::string& config) {
  const PipelineOptions options = config.empty() ? PipelineOptions() : readConfiguration(config);
  return options.fitting.person.stature;
}

}  // namespace
}  // namespace markerless_mocap

// Writes the URDF of a person to standard output.
int main(int argc, char** argv) {
  using namespace markerless_mocap;
  CLI::App app("Writes the URDF of a person with the stature of a configuration.", "human_urdf");
  std::string file, id = "person1", config;
  app.add_option("template", file, "URDF template, urdf/human.urdf.in")->required();
  app.add_option("--id", id, "suffix of links and joints");
  app.add_option("--config", config, "configuration; its pose_fitting/stature is used");
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("human_urdf", [&] { std::cout << bodyUrdf(file, id, statureOf(config)); });
}
