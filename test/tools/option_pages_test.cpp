#include "tools/describe_options/option_pages.h"

#include <gtest/gtest.h>

#include <sstream>

#include "markerless_mocap/pipeline/pipeline.h"
#include "option_list.h"
#include "tools/common/person_urdf.h"
#include "tools/describe_options/option_writers.h"

namespace markerless_mocap {
namespace {

std::string file(const std::string& name) {
  return readText(std::string(MOCAP_SOURCE_DIR) + "/" + name);
}

std::string valuesOfAll(PipelineOptions options) {
  std::string lines;
  forEachStage(options, [&](const char* section, const auto& stage) {
    lines += std::string(section) + "\n" + valuesOf(stage);
  });
  return lines;
}

TEST(OptionPages, ManualIsUpToDate) {
  EXPECT_TRUE(parameterPage() == file("docs/parameters.md"))
      << "renew it: describe_options > docs/parameters.md";
}

TEST(OptionPages, PageOfAllOptionsIsUpToDate) {
  EXPECT_TRUE(allOptionsPage() == file("config/all_options.yaml"))
      << "renew it: describe_options --yaml > config/all_options.yaml";
}

TEST(OptionPages, PageOfAllOptionsHoldsAllAndIsReadAsTheDefaults) {
  const YAML::Node page = YAML::Load(allOptionsPage());
  EXPECT_EQ(valuesOfAll(loadPipelineOptions(page)), valuesOfAll(PipelineOptions()));
  PipelineOptions stages;
  forEachStage(stages, [&](const char* section, const auto& stage) {
    for (const auto& entry : optionsOf(stage)) {
      YAML::Node node = YAML::Clone(page[section]);
      std::istringstream path(entry.path);
      for (std::string key; std::getline(path, key, '/');) node.reset(node[key]);
      EXPECT_TRUE(node.IsDefined() && !node.IsNull()) << section << '/' << entry.path;
    }
  });
}

TEST(OptionPages, DefaultConfigurationChangesNothing) {
  const YAML::Node root = YAML::Load(file("config/default.yaml"));
  EXPECT_GT(root.size(), 2u);
  EXPECT_EQ(valuesOfAll(loadPipelineOptions(root)), valuesOfAll(PipelineOptions()));
}

struct SampleOptions {
  double pitch = 0.03;
  std::string method = "walk";
  double lower = -1.0, upper = 0.5;
  struct {
    int views = 2;
    void visit(OptionVisitor& v) { v.field("views", views, 2, 32, "cameras"); }
  } inner;
  void visit(OptionVisitor& v) {
    v.field("pitch", pitch, 0.005, 0.2, "edge of a voxel, m");
    v.section("inner", inner, "what is within");
    v.field("method", method, {"walk", "tree"}, "how");
    v.range("knee", lower, upper, -3, 3, "rad");
  }
};

TEST(OptionWriters, TableHasARowPerFieldAndATablePerSection) {
  TableWriter writer("## ", "sample", "");
  SampleOptions options;
  options.visit(writer);
  EXPECT_EQ(writer.page(),
            "\n## sample\n\n"
            "| key | default | allowed | meaning |\n|---|---|---|---|\n"
            "| `pitch` | 0.03 | 0.005 to 0.2 | edge of a voxel, m |\n"
            "| `method` | \"walk\" | one of walk, tree | how |\n"
            "| `knee` | [-1, 0.5] | [min, max], each -3 to 3 | rad |\n"
            "\n### sample/inner\n\nwhat is within\n\n"
            "| key | default | allowed | meaning |\n|---|---|---|---|\n"
            "| `views` | 2 | a whole number, 2 to 32 | cameras |\n");
}

TEST(OptionWriters, YamlNestsSections) {
  YamlWriter writer("");
  SampleOptions options;
  options.visit(writer);
  EXPECT_EQ(writer.lines(),
            "# edge of a voxel, m\npitch: 0.03\n"
            "# what is within\ninner:\n  # cameras\n  views: 2\n"
            "# how\nmethod: \"walk\"\n"
            "# rad\nknee: [-1, 0.5]\n");
}

}  // namespace
}  // namespace markerless_mocap
