#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "markerless_mocap/body/body_urdf.h"
#include "markerless_mocap/fitting/pose_tracker.h"

namespace {

std::string textOf(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::invalid_argument(file + " cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The stature that the configuration gives the pose fitting, metres.
double statureOf(const std::string& config) {
  const YAML::Node root = YAML::Load(config.empty() ? "{}" : textOf(config));
  return markerless_mocap::loadOptions<markerless_mocap::FittingOptions>(
             root[markerless_mocap::FittingOptions::kStage])
      .stature;
}

}  // namespace

// Writes the URDF of a person to the standard output.
int main(int argc, char** argv) {
  CLI::App app("Writes the URDF of a person of the stature that a configuration gives.");
  std::string file, id = "person1", config;
  app.add_option("template", file, "URDF template, urdf/human.urdf.in")->required();
  app.add_option("--id", id, "suffix of links and joints");
  app.add_option("--config", config, "configuration; its pose_fitting/stature is used");
  CLI11_PARSE(app, argc, argv);
  try {
    const auto proportions = markerless_mocap::BodyProportions::fromStature(statureOf(config));
    std::cout << markerless_mocap::fillUrdfTemplate(textOf(file), id, proportions);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "human_urdf: " << error.what() << '\n';
    return 1;
  }
}
