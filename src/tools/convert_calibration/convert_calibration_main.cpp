#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/common/arguments.h"
#include "tools/common/run_tool.h"
#include "tools/convert_calibration/convert_calibration.h"

int main(int argc, char** argv) {
  using namespace markerless_mocap;
  CLI::App app(
      "Reads the calibration of a rig in any known format and writes it in another one. With one "
      "path or --show it only says what it reads.",
      "convert_calibration");
  ConversionOptions options;
  std::vector<std::string> paths;
  bool show = false;
  app.add_option("paths", paths,
                 "files or folders to read, told by their content, and last the file or folder to "
                 "write")
      ->required();
  app.add_option("--to", options.format,
                 "rig, ros, kalibr, opencv, matrices, qualisys, anipose, caliscope, freemocap, "
                 "pose2sim, easymocap or colmap; else .yaml is a rig file, .qca.txt is Qualisys");
  app.add_option("--scale-to-metres", options.scale_to_metres,
                 "metres per unit of the input; 0: as the format or the distances say")
      ->capture_default_str();
  app.add_option("--up", options.up,
                 "axis of the input that points up: z, -z, y ...; auto: as the images say")
      ->capture_default_str();
  app.add_option("--size", options.size,
                 "image size such as 1280x720, for formats without one (3x4 matrices, OpenCV)");
  app.add_flag("--overwrite", options.overwrite, "replace files that exist");
  app.add_flag("--show", show, "read all paths and write nothing");
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("convert_calibration", [&] {
    if (paths.size() > 1 && !show) {
      options.output = paths.back();
      paths.pop_back();
    }
    options.inputs = paths;
    print(convertCalibration(options), std::cout);
  });
}
