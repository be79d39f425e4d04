#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/common/arguments.h"
#include "tools/common/run_tool.h"
#include "tools/export_hull/export_hull.h"

int main(int argc, char** argv) {
  CLI::App app("Writes hulls of a bag as point cloud files.", "export_hull");
  markerless_mocap::HullExportOptions what;
  app.add_option("input", what.input,
                 "bag written by mocap_offline, or a recorded bag with "
                 "hull/points and hull/grid")
      ->required();
  app.add_option("output", what.output, "file to write: .pcd or .ply")->required();
  app.add_option("--topic", what.topic,
                 "topic of the hulls, with the topic of the grid in the same namespace")
      ->capture_default_str();
  app.add_option("--at", what.at,
                 "seconds after the first hull: export the next hull from there on")
      ->check(CLI::NonNegativeNumber);
  app.add_flag("--all", what.all, "export all hulls, one file each, with the stamp in the name");
  app.add_flag("--ascii", what.ascii, "text instead of binary numbers");
  if (const auto code = markerless_mocap::parseArguments(app, argc, argv)) return *code;
  return markerless_mocap::runTool("export_hull", [&] {
    for (const std::string& file : markerless_mocap::exportHulls(what)) std::cout << file << '\n';
  });
}
