#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "error_text_of.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "option_list.h"

namespace markerless_mocap {
namespace {

/// Default of every option by its path.
std::map<std::string, YAML::Node> defaults() {
  std::map<std::string, YAML::Node> values;
  PipelineOptions stages;
  forEachStage(stages, [&](const std::string& section, const auto& stage) {
    for (const auto& entry : optionsOf(stage))
      if (!entry.is_section) values[section + "/" + entry.path] = YAML::Load(entry.value);
  });
  return values;
}

std::string errorOf(const YAML::Node& root) {
  return errorTextOf([&] { loadPipelineOptions(root); });
}

std::string errorOf(const std::string& yaml) {
  return errorOf(YAML::Load(yaml));
}

/// The default that an error about a renamed key points to; undefined if it points to none.
YAML::Node valueNamedBy(const std::string& error, const std::string& old_path) {
  static const std::regex kSentence(
      R"(^(\S+) is now (?:the (first|second) number of )?([a-z0-9_/]+)(?:, a pair \[min, max\])?$)");
  std::smatch words;
  if (!std::regex_match(error, words, kSentence) || words[1] != old_path)
    return YAML::Node(YAML::NodeType::Undefined);
  const auto all = defaults();
  const auto found = all.find(words[3]);
  if (found == all.end()) return YAML::Node(YAML::NodeType::Undefined);
  return words[2].length() ? found->second[words[2] == "second" ? 1 : 0] : found->second;
}

std::string shown(const YAML::Node& node) {
  YAML::Emitter out;
  out.SetSeqFormat(YAML::Flow);
  out << node;
  return out.c_str();
}

TEST(RenamedOptions, EveryOldKeyWorksOrNamesTheOptionThatTakesItsPlace) {
  const YAML::Node old = YAML::LoadFile(MOCAP_SOURCE_DIR "/test/pipeline/old_default.yaml");
  int working = 0, renamed = 0;
  for (const auto& section : old)
    for (const auto& entry : section.second) {
      const std::string name = section.first.Scalar(), key = entry.first.Scalar();
      YAML::Node root;
      root[name][key] = entry.second;
      const std::string error = errorOf(root);
      ++(error.empty() ? working : renamed);
      const YAML::Node now =
          error.empty() ? defaults()[name + "/" + key] : valueNamedBy(error, name + "/" + key);
      ASSERT_TRUE(now.IsDefined()) << name << '/' << key << ": " << error;
      EXPECT_EQ(shown(now), shown(entry.second)) << name << '/' << key << ": " << error;
    }
  EXPECT_EQ(working, 40);
  EXPECT_EQ(renamed, 90);
}

TEST(RenamedOptions, SentencesNameTheNewKey) {
  EXPECT_EQ(errorOf("pose_fitting: {contour_rays: 900}"),
            "pose_fitting/contour_rays is now pose_fitting/contour/rays");
  EXPECT_EQ(errorOf("pose_fitting: {filter: false}"),
            "pose_fitting/filter is now pose_fitting/filter/enabled");
  EXPECT_EQ(errorOf("pose_fitting: {neck_x_highest: 1}"),
            "pose_fitting/neck_x_highest is now the second number of "
            "pose_fitting/hsiao/joint_limits/neck_x, a pair [min, max]");
  EXPECT_EQ(errorOf("body_segmentation: {highest_cost: 3}"),
            "body_segmentation/highest_cost is now body_segmentation/max_cost");
}

TEST(RenamedOptions, OldNamesOfMethodsNameTheNewOnes) {
  EXPECT_EQ(errorOf("pose_fitting: {method: skeleton}"),
            "pose_fitting/method is \"skeleton\", which is now \"hsiao\"");
  EXPECT_EQ(errorOf("pose_fitting: {method: sppso}"),
            "pose_fitting/method is \"sppso\", which is now \"fleischmann\"");
}

TEST(RenamedOptions, AreThoseOfTheirOwnSectionOnly) {
  EXPECT_EQ(errorOf("visual_hull: {contour_rays: 900}").find("is now"), std::string::npos);
  EXPECT_EQ(errorOf("pose_fitting: {hsiao: {contour_rays: 900}}").find("is now"),
            std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
