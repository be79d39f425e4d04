#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {
namespace {

/// Throws on a section of which there is no stage.
void checkSections(const YAML::Node& root) {
  OptionReader reader(root, "configuration");
  PipelineOptions stages;
  forEachStage(stages, [&](const char* section, const auto&) { reader.allow(section); });
  reader.finish();
}

}  // namespace

PipelineOptions loadPipelineOptions(const YAML::Node& root) {
  PipelineOptions options;
  if (!root || root.IsNull()) return options;
  checkSections(root);
  forEachStage(options, [&](const char* section, auto& stage) {
    stage = loadOptions<std::decay_t<decltype(stage)>>(root[section]);
  });
  return options;
}

}  // namespace markerless_mocap
