#include "tools/describe_options/option_pages.h"

#include "capture/studio_options.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "ros/node_options.h"
#include "tools/describe_options/option_writers.h"

namespace markerless_mocap {
namespace {

template <class OptionsT>
std::string tableOf(OptionsT options, const std::string& title = OptionsT::kStage) {
  TableWriter writer("## ", title, "");
  options.visit(writer);
  return writer.page();
}

template <class OptionsT>
std::string nodeTable() {
  return tableOf(OptionsT(), "node " + std::string(OptionsT::kStage));
}

}  // namespace

std::string parameterPage() {
  std::string page =
      "# Parameters\n\n"
      "One section per stage, in the configuration file and as the private parameters of the node "
      "of that\nname. `pose_fitting/filter` is the key `filter` of the section `pose_fitting`, a "
      "map of the keys in the\ntable of that title. A key that is not listed or a value out of "
      "range stops the program with a\nmessage that names it. This page is the output of "
      "`describe_options`.\n";
  PipelineOptions stages;
  forEachStage(stages, [&](const char*, const auto& stage) { page += tableOf(stage); });
  page += tableOf(StudioOptions());
  page +=
      "\n# Parameters of the nodes alone\n\n"
      "Beside the above, in the same private namespace; the launch files set them, a configuration "
      "file does\nnot hold them.\n";
  return page + nodeTable<SilhouetteNodeOptions>() + nodeTable<HullNodeOptions>() +
         nodeTable<FittingNodeOptions>() + nodeTable<StudioNodeOptions>() +
         nodeTable<UsbCameraOptions>();
}

std::string allOptionsPage() {
  std::string page =
      "# Every option with its default; what a configuration leaves out keeps it. Written by\n"
      "# `describe_options --yaml`; docs/parameters.md has the allowed values.\n";
  PipelineOptions stages;
  forEachStage(stages, [&](const char* section, auto& stage) {
    YamlWriter writer("  ");
    stage.visit(writer);
    page += "\n" + std::string(section) + ":\n" + writer.lines();
  });
  return page;
}

}  // namespace markerless_mocap
