#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/common/run_tool.h"
#include "tools/export_hull/export_hull.h"

int main(int argc, char** argv) {
  CLI::App app("Writes hulls of a bag as point clouds for other programs.", "export_hull");
  markerless_mocap::HullExportOptions what;
  app.add_option("input", what.input,
                 "bag that mocap_offline has written, or a recorded one with "
                 "hull/points and hull/grid")
      ->required();
  app.add_option("output", what.output, "file to write: .pcd or .ply")->required();
  app.add_option("--topic", what.topic, "topic of the hulls; its grid is beside it")
      ->capture_default_str();
  app.add_option("--at", what.at, "the first hull from this many seconds after the first one")
      ->check(CLI::NonNegativeNumber);
  app.add_flag("--all", what.all, "one file per instant, its stamp in the name");
  app.add_flag("--ascii", what.ascii, "text in place of binary numbers");
  CLI11_PARSE(app, argc, argv);
  return markerless_mocap::runTool("export_hull", [&] {
    for (const std::string& file : markerless_mocap::exportHulls(what)) std::cout << file << '\n';
  });
}
