#include "studies/reproduce/reproduce.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/common/progress.h"
#include "tools/common/run_tool.h"

namespace {

using namespace markerless_mocap;

struct Arguments {
  std::string paper;
  ReproduceRequest request;
  std::vector<std::string> studio;
  RunListOptions run;
};

void describe(CLI::App& app, Arguments* arguments) {
  std::vector<std::string> names;
  for (const auto& [name, make] : papers()) names.push_back(name);
  app.add_option("paper", arguments->paper, "whose experiments are re-made")
      ->required()
      ->check(CLI::IsMember(names));
  app.add_option("folder", arguments->request.folder,
                 "for index.html; a run that was interrupted goes on where it was")
      ->required();
  app.add_flag("--quick", arguments->request.quick, "minutes in place of hours: a part of it all");
  app.add_option("--seeds", arguments->request.seeds,
                 "runs of each random method; default: 5, quick: 1 (fleischmann at 20 fps: 5)")
      ->check(CLI::Range(1, 100));
  app.add_option("--studio", arguments->studio,
                 "KEY=VALUE of virtual_studio for all captures, may be given repeatedly");
  app.add_option("--at-once", arguments->run.at_once, "runs at the same time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_flag("--again", arguments->run.again, "do also what is in FOLDER/cache");
}

void run(CLI::App& app, Arguments* arguments) {
  ReproduceRequest& request = arguments->request;
  if (request.quick && app.count("--seeds") == 0) request.seeds = 1;
  arguments->run.notes = &std::cerr;
  arguments->run.terminal = isStderrTerminal();
  arguments->run.interrupted = catchInterruptions();
  const std::unique_ptr<Paper> paper = papers().at(arguments->paper)(request);
  for (const Claim& claim :
       reproduce(*paper, request, parseOverrides(arguments->studio, "--studio"), arguments->run))
    std::cout << verdictName(claim.verdict) << ": " << claim.sentence << " (" << claim.place
              << ")\n    here: " << claim.ours << '\n';
  std::cout << "written: " << (request.folder / "index.html").string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Re-makes the experiments of a paper and says which of its claims hold here.",
               "reproduce");
  Arguments arguments;
  describe(app, &arguments);
  CLI11_PARSE(app, argc, argv);
  return runTool("reproduce", [&] { run(app, &arguments); });
}
