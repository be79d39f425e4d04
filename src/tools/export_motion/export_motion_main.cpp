#include <CLI/CLI.hpp>
#include <iostream>

#include "exports/point_names.h"
#include "tools/common/arguments.h"
#include "tools/common/run_tool.h"
#include "tools/export_motion/export_motion.h"

int main(int argc, char** argv) {
  using namespace markerless_mocap;
  CLI::App app("Writes the motion of a person as a file of other programs.", "export_motion");
  app.footer("Formats, by the suffix of the output:\n" + motionFormats() +
             "docs/export.md describes axes, units, root and names of each.");
  MotionExportOptions what;
  app.add_option("input", what.input, "bag written by mocap_offline, or a recorded bag with tf")
      ->required();
  app.add_option("output", what.output, "file to write; replaced if it exists")->required();
  app.add_option("--names", what.names,
                 "names of the joints: package, motionbuilder, opensim, h36m, smpl or coco");
  app.add_option("--joints", what.joints, "write these joints only (.trc, .c3d, .csv)");
  app.add_option("--fill", what.fill_ms,
                 "fill gaps by splines where the frames on both sides are at most this many "
                 "milliseconds apart")
      ->check(CLI::NonNegativeNumber);
  app.add_flag("--metres", what.metres, "metres instead of centimetres (.bvh)");
  app.add_flag("--angles", what.angles, "angles of the URDF's joints instead of places (.csv)");
  app.add_option("--id", what.body_id, "id of the body if the bag has several");
  app.add_option("--urdf", what.urdf, "URDF of the body if the bag has none");
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("export_motion", [&] { exportMotion(what, std::cerr); });
}
