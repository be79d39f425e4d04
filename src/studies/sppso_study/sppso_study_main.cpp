#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "resources/resources.h"
#include "ros/package_files.h"
#include "studies/sppso_study/fleischmann_report.h"
#include "tools/common/number_format.h"
#include "tools/common/person_urdf.h"
#include "tools/common/run_tool.h"
#include "tools/common/studio_settings.h"

namespace {

using namespace markerless_mocap;

struct Arguments {
  std::string folder, statistics;
  std::vector<std::string> studio, search, tables;
  int frames = 450;
  int max_runs = 5;
};

void describe(CLI::App& app, Arguments* arguments) {
  app.add_option("folder", arguments->folder, "folder for index.html and runs.csv")->required();
  app.add_option("--frames", arguments->frames, "number of frames, at 60 per second")
      ->check(CLI::Range(30, 100000))
      ->capture_default_str();
  app.add_option("--runs", arguments->max_runs, "maximum number of runs per variant")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("--table", arguments->tables,
                 "6.2, 6.5, 6.6, 6.8, 6.10 or ours, may be given repeatedly; default: all");
  app.add_option("--studio", arguments->studio,
                 "KEY=VALUE of virtual_studio; default: four cameras of 644 x 484 and a walk in "
                 "a circle");
  app.add_option("--set", arguments->search, "KEY=VALUE of the search, for all variants");
  app.add_option("--statistics", arguments->statistics,
                 "file of motion_statistics; default: that of the package");
}

StudioOptions studioOf(const Arguments& arguments) {
  Overrides overrides = {{"rig", "ring4"},  {"width", "644"},
                         {"height", "484"}, {"motion", "walk_in_circle"},
                         {"fps", "60"},     {"duration", "0"}};
  for (const auto& change : parseOverrides(arguments.studio, "--studio"))
    overrides.push_back(change);
  return readStudioOptions("", overrides);
}

FleischmannOptions searchOf(const Arguments& arguments) {
  YAML::Node node(YAML::NodeType::Map);
  node["include_start_particle"] = false;  // as published
  for (const auto& [key, value] : parseOverrides(arguments.search, "--set")) node[key] = value;
  return loadOptions<FleischmannOptions>(node);
}

std::vector<StudyTable> wantedTables(const Arguments& arguments, const FleischmannOptions& base) {
  std::vector<StudyTable> wanted;
  for (StudyTable& table : studyTables(base)) {
    const auto& names = arguments.tables;
    if (!names.empty() && std::find(names.begin(), names.end(), table.id) == names.end()) continue;
    for (StudyVariant& variant : table.variants)
      variant.runs = std::min(variant.runs, arguments.max_runs);
    wanted.push_back(table);
  }
  if (wanted.empty()) throw std::invalid_argument("--table names an unknown table");
  return wanted;
}

std::vector<StudiedTable> studied(const FleischmannSequence& film,
                                  const FleischmannMotionStatistics& statistics,
                                  const std::vector<StudyTable>& tables) {
  std::vector<StudiedTable> out;
  for (const StudyTable& table : tables) {
    out.push_back({table, {}});
    for (const StudyVariant& variant : table.variants) {
      out.back().results.push_back(runVariant(film, statistics, variant));
      const StudyResult& result = out.back().results.back();
      std::cerr << table.id << ' ' << variant.name << ": "
                << formatNumber("mean %.1f mm", result.meanError())
                << formatNumber(", maximum %.1f mm", result.maxError()) << std::endl;
    }
  }
  return out;
}

void run(const Arguments& arguments) {
  const FleischmannOptions search = searchOf(arguments);
  const std::vector<StudyTable> tables = wantedTables(arguments, search);
  const std::string& own = arguments.statistics;
  const FleischmannMotionStatistics statistics =
      FleischmannMotionStatistics::fromYaml(own.empty() ? motionStatisticsYaml() : readText(own));
  std::filesystem::create_directories(arguments.folder);
  const StudioOptions studio = studioOf(arguments);
  const StudioFiles files{humanUrdfTemplate(), packageFile("config/motions")};
  const FleischmannSequence film = filmOf(studio, files, arguments.frames, [&](int done) {
    std::cerr << "rendered " << done << " of " << arguments.frames << std::endl;
  });
  StudyReport report;
  report.about = std::to_string(film.frames.size()) + " frames of " + studio.motion + " by " +
                 std::to_string(film.rig.size()) + " cameras, " + std::to_string(studio.width) +
                 " x " + std::to_string(studio.height) +
                 "; limb lengths and first pose are known. D is the mean error of fifteen joints.";
  report.tables = studied(film, statistics, tables);
  constexpr int kSwing = kRightShoulder + 1;  // Fleischmann's x24
  report.parameter = fleischmannParameterNames()[kSwing];
  report.curves = fitnessCurves(film, film.frames.size() / 3, kSwing,
                                statistics.over(1.0 / 20.0)[kSwing], search);
  report.time = timeByPart(film, statistics, search);
  writeText(std::filesystem::path(arguments.folder) / "index.html", studyPage(report));
  writeText(std::filesystem::path(arguments.folder) / "runs.csv", studyCsv(report.tables));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Tracks a rendered walk with variants of Fleischmann's method and compares them.",
               "sppso_study");
  Arguments arguments;
  describe(app, &arguments);
  CLI11_PARSE(app, argc, argv);
  return runTool("sppso_study", [&] { run(arguments); });
}
