#include <CLI/CLI.hpp>
#include <iostream>

#include "studies/eigenmap_figures/eigenmap_figures.h"
#include "tools/common/run_tool.h"

int main(int argc, char** argv) {
  CLI::App app("Draws the segmentation of bodies in Laplacian eigenspace: a test image and hulls.",
               "eigenmap_figures");
  markerless_mocap::EigenmapFigureOptions what;
  app.add_option("folder", what.folder, "folder for the images (.png)")->required();
  app.add_option("--hulls", what.input, "bag with hulls; without it only the test image is drawn");
  app.add_option("--topic", what.topic,
                 "topic of the hulls, with the topic of the grid in the same namespace")
      ->capture_default_str();
  app.add_option("--at", what.at,
                 "seconds after the first hull: start with the next hull from there on")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--frame-sets", what.frame_sets, "number of successive hulls")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return markerless_mocap::runTool("eigenmap_figures", [&] {
    for (const std::string& file : markerless_mocap::drawEigenmapFigures(what))
      std::cout << file << '\n';
  });
}
