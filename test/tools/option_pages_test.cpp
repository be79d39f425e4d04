#include "tools/describe_options/option_pages.h"

#include <gtest/gtest.h>

#include "markerless_mocap/pipeline/pipeline.h"
#include "tools/common/person_urdf.h"

namespace markerless_mocap {
namespace {

std::string file(const std::string& name) {
  return readText(std::string(MOCAP_SOURCE_DIR) + "/" + name);
}

TEST(OptionPages, ManualIsUpToDate) {
  EXPECT_TRUE(parameterPage() == file("docs/parameters.md"))
      << "renew it: describe_options > docs/parameters.md";
}

TEST(OptionPages, DefaultConfigurationIsUpToDate) {
  EXPECT_TRUE(defaultConfiguration() == file("config/default.yaml"))
      << "renew it: describe_options --yaml > config/default.yaml";
}

TEST(OptionPages, DefaultConfigurationIsReadAsTheDefaults) {
  PipelineOptions read = loadPipelineOptions(YAML::Load(defaultConfiguration()));
  PipelineOptions defaults;
  std::string rows_read, rows_default;
  forEachStage(read, [&](const char*, auto& stage) {
    OptionDescriber describer;
    stage.visit(describer);
    rows_read += describer.rows();
  });
  forEachStage(defaults, [&](const char*, auto& stage) {
    OptionDescriber describer;
    stage.visit(describer);
    rows_default += describer.rows();
  });
  EXPECT_EQ(rows_read, rows_default);
}

}  // namespace
}  // namespace markerless_mocap
