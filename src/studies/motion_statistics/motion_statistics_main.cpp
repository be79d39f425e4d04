#include <CLI/CLI.hpp>
#include <sstream>

#include "resources/resources.h"
#include "ros/package_files.h"
#include "studies/common/true_parameters.h"
#include "tools/common/person_urdf.h"
#include "tools/common/run_tool.h"

namespace {

using namespace markerless_mocap;

void write(const std::string& path, const std::vector<std::string>& motions) {
  const StudioFiles files{humanUrdfTemplate(), packageFile("config/motions")};
  const FleischmannMotionStatistics statistics = statisticsOf(motions, StudioOptions(), files);
  std::ostringstream out;
  out << "# Made by: rosrun markerless_mocap motion_statistics models/motion_statistics.yaml "
         "--motion";
  for (const std::string& motion : motions) out << ' ' << motion;
  out << "\n# Largest change of each of the 31 parameters between two frames at 60 fps over these\n"
         "# motions, rad and m.\n"
      << statistics.toYaml();
  writeText(path, out.str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures the maximum changes of the parameters of Fleischmann's tracker.",
               "motion_statistics");
  std::string output;
  std::vector<std::string> motions = {"walk", "stroll_arms_down", "wave_and_walk"};
  app.add_option("output", output, "YAML file to write")->required();
  app.add_option("--motion", motions,
                 "names of motions in config/motions, or paths of .yaml or .bvh files")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return runTool("motion_statistics", [&] { write(output, motions); });
}
