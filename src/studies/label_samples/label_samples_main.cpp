#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "resources/resources.h"
#include "studies/label_samples/label_samples.h"
#include "tools/common/person_urdf.h"
#include "tools/common/run_tool.h"
#include "tools/common/studio_settings.h"

namespace {

using namespace markerless_mocap;

struct Arguments {
  LabelSampleOptions film;
  std::string output, motion, rig;
  std::vector<std::string> overrides;
};

void describe(CLI::App& app, Arguments* arguments) {
  LabelSampleOptions& film = arguments->film;
  app.add_option("output", arguments->output, "file to write; replaced if it exists")->required();
  app.add_option("--motion", arguments->motion,
                 "name of a motion in config/motions, or path of a .yaml or .bvh file");
  app.add_option("--rig", arguments->rig,
                 "ring8, ring7_overhead, ring4, ceiling4, random8 or path of a rig file");
  app.add_option("--set", arguments->overrides,
                 "KEY=VALUE of the section virtual_studio, may be given repeatedly");
  app.add_option("--pitch", film.pitch, "of the hulls, metres per voxel")->capture_default_str();
  app.add_option("--frames", film.frames, "number of frames, distributed evenly over the motion")
      ->capture_default_str();
  app.add_flag("--silhouettes", film.silhouettes,
               "extract silhouettes from the images; default: exact masks");
}

void run(Arguments* arguments) {
  LabelSampleOptions& film = arguments->film;
  film.studio = readStudioOptions("", parseOverrides(arguments->overrides, "--set"));
  if (!arguments->motion.empty()) film.studio.motion = arguments->motion;
  if (!arguments->rig.empty()) film.studio.rig = arguments->rig;
  film.files.urdf_template = humanUrdfTemplate();
  film.files.motions_folder = packageFile("config/motions");
  film.interrupted = catchInterruptions();
  const std::string part = arguments->output + ".part";
  std::ofstream out(part);
  if (!out) throw std::runtime_error(part + " cannot be written");
  writeLabelSamples(film, &out);
  out.close();
  if (!out || std::rename(part.c_str(), arguments->output.c_str()) != 0)
    throw std::runtime_error(arguments->output + " cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Renders a virtual person and writes training samples for the models of the pose tree.",
      "label_samples");
  Arguments arguments;
  describe(app, &arguments);
  CLI11_PARSE(app, argc, argv);
  return runTool("label_samples", [&] { run(&arguments); });
}
