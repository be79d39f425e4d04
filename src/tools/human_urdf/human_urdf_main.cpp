#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "markerless_mocap/body/body_urdf.h"
#include "markerless_mocap/pipeline/tracker_options.h"
#include "tools/common/person_urdf.h"
#include "tools/common/run_tool.h"

namespace markerless_mocap {
namespace {

/// pose_fitting/stature of a configuration, metres.
double statureOf(const std::string& config) {
  const YAML::Node root = YAML::Load(config.empty() ? "{}" : readText(config));
  return loadOptions<TrackerOptions>(root[TrackerOptions::kStage]).person.stature;
}

}  // namespace
}  // namespace markerless_mocap

// Writes the URDF of a person to standard output.
int main(int argc, char** argv) {
  using namespace markerless_mocap;
  CLI::App app("Writes the URDF of a person with the stature of a configuration.");
  std::string file, id = "person1", config;
  app.add_option("template", file, "URDF template, urdf/human.urdf.in")->required();
  app.add_option("--id", id, "suffix of links and joints");
  app.add_option("--config", config, "configuration; its pose_fitting/stature is used");
  CLI11_PARSE(app, argc, argv);
  return runTool("human_urdf", [&] {
    const auto proportions = BodyProportions::fromStature(statureOf(config));
    std::cout << fillUrdfTemplate(readText(file), id, proportions);
  });
}
