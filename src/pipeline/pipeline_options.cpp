#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {
namespace {

/// Leaves what no stage is named for to the reader, which refuses it with the nearest stage.
void checkSections(const YAML::Node& root) {
  YAML::Node unknown = YAML::Clone(root);
  PipelineOptions stages;
  if (unknown.IsMap())
    forEachStage(stages, [&](const char* section, const auto&) { unknown.remove(section); });
  OptionReader reader(unknown, "configuration");
  forEachStage(stages, [&](const char* section, const auto&) {
    bool absent = false;
    reader.field(section, absent, "");
  });
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
