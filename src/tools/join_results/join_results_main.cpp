#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "tools/common/arguments.h"
#include "tools/common/run_tool.h"
#include "tools/join_results/join_results.h"

namespace {

using namespace markerless_mocap;

constexpr int kDisagree = 3;

void print(const std::vector<Seam>& seams) {
  for (const Seam& seam : seams)
    std::fprintf(stderr, "joined at %.3f s: %d frame sets agree, joints at most %.1f mm apart\n",
                 1e-9 * double(seam.stamp_ns), seam.frame_sets, 1e3 * seam.largest_distance_m);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Joins the results of parts of a recording that overlap.", "join_results");
  app.footer(
      "Parts are made by mocap_offline --prepared FOLDER --start S --duration S; neighbours must "
      "overlap by some seconds.\nExit code: 0 joined, 1 an error, 3 two parts do not agree; then "
      "the number of the later one is printed.");
  JoinOptions options;
  app.add_option("output", options.output, "bag to write; replaced if it exists")->required();
  app.add_option("parts", options.parts, "bags of mocap_offline, in the order of time")->required();
  app.add_option("--json", options.figures, "file for the figures of the whole");
  double max_distance_mm = 1e3 * options.max_distance_m;
  app.add_option("--max-distance", max_distance_mm,
                 "how far the joints may be apart in an overlap, mm, mean over the joints")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  options.max_distance_m = 1e-3 * max_distance_mm;
  size_t disagreeing = 0;
  const int code = runTool("join_results", [&] {
    catchInterruptions();
    try {
      print(joinResults(options));
    } catch (const Disagreement& error) {
      disagreeing = error.later_part;
      throw;
    }
  });
  if (disagreeing == 0) return code;
  std::cout << disagreeing + 1 << '\n';
  return kDisagree;
}
