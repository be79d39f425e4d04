#include <yaml-cpp/yaml.h>

#include "fuzz_target.h"
#include "markerless_mocap/tracking/filter_options.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/shape_file.h"

using namespace markerless_mocap;

namespace {

template <class OptionsT>
void load(const YAML::Node& root) {
  refusesOrReads([&] {
    OptionsT options;
    OptionReader reader(root, OptionsT::kStage);
    options.visit(reader);
    reader.finish();
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = textOf(data, size);
  refusesOrReads([&] { shapeFromYaml(text, "fuzz"); });
  refusesOrReads([&] { ShapeStatistics::fromYaml(text, "fuzz"); });
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::Exception&) {
    return 0;
  }
  load<PersonOptions>(root);
  load<FilterOptions>(root);
  return 0;
}
