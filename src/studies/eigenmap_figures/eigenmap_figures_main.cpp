#include <CLI/CLI.hpp>
#include <iostream>

#include "studies/eigenmap_figures/eigenmap_figures.h"
#include "tools/common/run_tool.h"

int main(int argc, char** argv) {
  CLI::App app("Draws how bodies are segmented in Laplacian eigenspace: a test image and hulls.",
               "eigenmap_figures");
  markerless_mocap::EigenmapFigureOptions what;
  app.add_option("folder", what.folder, "folder for the pictures (.png)")->required();
  app.add_option("--hulls", what.input, "bag with hulls; without one only the test image is drawn");
  app.add_option("--topic", what.topic, "topic of the hulls; its grid is beside it")
      ->capture_default_str();
  app.add_option("--at", what.at, "the first hull from this many seconds after the first one")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--instants", what.frame_sets, "so many hulls from there on")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return markerless_mocap::runTool("eigenmap_figures", [&] {
    for (const std::string& file : markerless_mocap::drawEigenmapFigures(what))
      std::cout << file << '\n';
  });
}
