#include "files/yaml_text.h"

#include <gtest/gtest.h>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

std::string refusal(const std::string& text) {
  return errorTextOf([&] { yamlFrom(text, "a.yaml"); });
}

std::string nested(int levels, const std::string& level) {
  std::string text;
  for (int i = 0; i < levels; ++i) text += level;
  return text;
}

TEST(YamlText, IsRead) {
  EXPECT_EQ(yamlFrom("a: [1, 2]", "a.yaml")["a"][1].as<int>(), 2);
  EXPECT_TRUE(yamlFrom("", "a.yaml").IsNull());
}

TEST(YamlText, FaultsOfALaterDocumentAreTold) {
  EXPECT_EQ(yamlDocumentsFrom("a: 1\n---\nb: 2", "a.yaml").size(), 2u);
  EXPECT_EQ(errorTextOf([] { yamlDocumentsFrom("a: 1\n---\nb: [1", "a.yaml"); }).substr(0, 18),
            "a.yaml is no YAML:");
}

TEST(YamlText, ThatNestsTooDeepIsToldSo) {
  const std::string sentence = "a.yaml is no YAML: it nests deeper than the 500 levels";
  EXPECT_EQ(refusal("a: " + nested(100000, "[") + nested(100000, "]")).rfind(sentence, 0), 0u);
  EXPECT_EQ(refusal(nested(100000, "{a: ")).rfind(sentence, 0), 0u);
  EXPECT_EQ(refusal(nested(5000, "? ")).rfind(sentence, 0), 0u);
  EXPECT_EQ(yamlFrom("a: " + nested(100, "[") + nested(100, "]"), "a.yaml")["a"].size(), 1u);
}

TEST(YamlText, FaultsAreToldInPlainWordsWithTheirPlace) {
  EXPECT_EQ(refusal("a: 1\nb: [1, 2"),
            "a.yaml is no YAML: a list that begins with [ has no comma or ] (line 2, column 1)");
  EXPECT_NE(refusal("a: {b: 1").find("a map that begins with {"), std::string::npos);
  EXPECT_NE(refusal("a: 1\n b: 2").find("lines of one map begin in one column"), std::string::npos);
  EXPECT_NE(refusal("a: \"b").find("a text in quotes has no end"), std::string::npos);
  EXPECT_NE(refusal("a: @b").find("unless in quotes (line 1, column 4)"), std::string::npos);
  EXPECT_NE(refusal("a: |\n x\n- c").find("belongs to no map"), std::string::npos);
  EXPECT_NE(refusal("a: *x").find("the referenced anchor is not defined"), std::string::npos);
}

TEST(YamlText, AValueOfAnotherKindIsToldWithItsLine) {
  try {
    yamlFrom("a: 1\nb: x", "a.yaml")["b"].as<double>();
    FAIL();
  } catch (const YAML::Exception& fault) {
    EXPECT_EQ(sentenceOf(fault),
              "a value is missing or not of the kind that is allowed (line 2, column 4)");
  }
}

}  // namespace
}  // namespace markerless_mocap
