#include <CLI/CLI.hpp>
#include <iostream>

#include "files/whole_file.h"
#include "tools/common/arguments.h"
#include "tools/common/description_text.h"
#include "tools/common/person_motion_reader.h"
#include "tools/common/run_tool.h"

int main(int argc, char** argv) {
  using namespace markerless_mocap;
  CLI::App app("Steps, trunk lean and ranges of motion of a person, with expected errors.",
               "describe_motion");
  std::string input, json, id, urdf;
  bool quiet = false;
  app.add_option("input", input, "bag written by mocap_offline, or a recorded bag with tf")
      ->required();
  app.add_option("--json", json, "write all values as JSON to this file");
  app.add_option("--id", id, "id of the body if the bag has several");
  app.add_option("--urdf", urdf, "URDF of the body if the bag has none");
  app.add_flag("--quiet", quiet, "no table");
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("describe_motion", [&] {
    const MotionDescription motion = describe(readPersonMotion(input, id, urdf));
    if (!json.empty()) writeWholeFile(json, descriptionJson(motion));
    if (!quiet) printDescription(motion, std::cout);
  });
}
