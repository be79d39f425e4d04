#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "files/whole_file.h"
#include "tools/common/arguments.h"
#include "tools/common/progress.h"
#include "tools/common/run_tool.h"
#include "tools/evaluate/evaluation.h"
#include "tools/evaluate/evaluation_json.h"
#include "tools/evaluate/evaluation_marks.h"
#include "tools/evaluate/evaluation_page.h"
#include "tools/evaluate/evaluation_table.h"

namespace {

using namespace markerless_mocap;

struct Arguments {
  EvaluationRequest request;
  std::string json, html, marks;
  bool quiet = false, no_images = false;
};

void describe(CLI::App& app, Arguments* arguments) {
  EvaluationRequest& request = arguments->request;
  app.add_option("results", request.results,
                 "bag with the results of a tracker: tf, pose, joint states, hull")
      ->required();
  auto* against = app.add_option_group("compared with")->require_option(1);
  against->add_option("--truth", request.truth, "bag with /ground_truth; may be the same file");
  against->add_option("--marks", arguments->marks,
                      "YAML file of marks set by hand in images of a recording without ground "
                      "truth; needs --rig, and takes --id, --json and --quiet");
  app.add_option("--json", arguments->json, "write all results as JSON to this file");
  app.add_option("--html", arguments->html,
                 "write a self-contained page to this file: it plays the motion beside "
                 "the truth");
  app.add_option("--skip", request.skip,
                 "leave out this many seconds at the begin of the ground truth")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--id", request.body_id, "id of the body if the results contain several");
  app.add_option("--rig", request.rig,
                 "rig file of the run: body and hull are drawn with its cameras");
  app.add_option("--config", request.config,
                 "configuration of the run: its hull options are used for the true hull");
  app.add_flag("--no-images", arguments->no_images,
               "do not evaluate silhouettes and hull, and show no images");
  app.add_flag("--quiet", arguments->quiet, "no progress and no table");
}

void runMarks(const Arguments& arguments) {
  const EvaluationRequest& request = arguments.request;
  if (request.rig.empty()) throw std::runtime_error("--marks needs --rig, the rig file of the run");
  if (!arguments.html.empty() || !request.config.empty() || request.skip > 0.0 ||
      arguments.no_images)
    throw std::runtime_error("--marks takes only --rig, --id, --json and --quiet");
  const MarksEvaluation evaluation =
      evaluateMarks(request.results, request.body_id, arguments.marks, request.rig);
  if (!arguments.json.empty()) writeWholeFile(arguments.json, marksJson(evaluation));
  if (!arguments.quiet) printMarks(evaluation, std::cout);
}

void run(Arguments* arguments) {
  EvaluationRequest& request = arguments->request;
  if (!arguments->marks.empty()) return runMarks(*arguments);
  request.images = !arguments->no_images;
  request.page = !arguments->html.empty();
  Progress progress("evaluate", arguments->quiet ? nullptr : &std::cerr, isStderrTerminal());
  const Evaluation evaluation =
      evaluate(request, [&](double fraction) { progress.update(fraction); });
  progress.finish();
  if (!arguments->json.empty()) writeWholeFile(arguments->json, evaluationJson(evaluation));
  if (!arguments->html.empty()) writeWholeFile(arguments->html, evaluationPage(evaluation));
  if (!arguments->quiet) printEvaluation(evaluation, std::cout);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Compares the results of a tracker with the ground truth, or with marks set by hand.",
      "evaluate");
  Arguments arguments;
  describe(app, &arguments);
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("evaluate", [&] { run(&arguments); });
}
