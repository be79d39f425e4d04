#include <CLI/CLI.hpp>
#include <iostream>

#include "resources/resources.h"
#include "tools/common/arguments.h"
#include "tools/common/person_urdf.h"
#include "tools/common/progress.h"
#include "tools/common/run_tool.h"
#include "tools/common/studio_settings.h"
#include "tools/render/render_capture.h"

namespace {

using namespace markerless_mocap;

struct Arguments {
  RenderOptions render;
  std::string config, motion, rig, urdf_template;
  std::vector<std::string> overrides;
  bool quiet = false;
};

void describe(CLI::App& app, Arguments* arguments) {
  RenderOptions& render = arguments->render;
  app.add_option("output", render.output, "bag to write; replaced if it exists")->required();
  app.add_option("--config", arguments->config, "YAML file with a section virtual_studio");
  app.add_option("--motion", arguments->motion,
                 "name of a motion in config/motions, or path of a .yaml or .bvh file");
  app.add_option(
      "--rig", arguments->rig,
      "ring8, ring7_overhead, ring4, ring16, ceiling4, random8, wide6 or path of a rig file");
  app.add_option("--set", arguments->overrides,
                 "KEY=VALUE of the section virtual_studio, may be given repeatedly");
  app.add_option("--images", render.images, "raw, jpeg or none")->capture_default_str();
  app.add_option("--jpeg-quality", render.jpeg_quality, "1 to 100")->capture_default_str();
  app.add_flag("--masks", render.masks, "also write <camera>/silhouette, degraded by mask_damage");
  app.add_option("--compression", render.compression, "of the bag: lz4 or none")
      ->capture_default_str();
  app.add_option("--rig-out", render.rig_out, "rig file to write");
  app.add_option("--id", render.body_id, "id of the body in the ground truth")
      ->capture_default_str();
  app.add_option("--urdf-template", arguments->urdf_template,
                 "URDF template, replaces that of the package");
  app.add_flag("--quiet", arguments->quiet, "no progress and no summary");
}

void run(Arguments* arguments) {
  RenderOptions& render = arguments->render;
  render.studio =
      readStudioOptions(arguments->config, parseOverrides(arguments->overrides, "--set"));
  if (!arguments->motion.empty()) render.studio.motion = arguments->motion;
  if (!arguments->rig.empty()) render.studio.rig = arguments->rig;
  const std::string& urdf = arguments->urdf_template;
  render.files.urdf_template =
      urdf.empty() ? humanUrdfTemplate() : readUrdfTemplate(urdf, render.body_id);
  render.files.motions_folder = packageFile("config/motions");
  render.interrupted = catchInterruptions();
  std::ostream* notes = arguments->quiet ? nullptr : &std::cerr;
  const RenderSummary summary = renderCapture(render, notes, isStderrTerminal());
  if (notes) print(summary, *notes);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Renders a virtual person into a bag, with the ground truth.", "render_capture");
  Arguments arguments;
  describe(app, &arguments);
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("render_capture", [&] { run(&arguments); });
}
