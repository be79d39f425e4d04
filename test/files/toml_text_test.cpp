#include "files/toml_text.h"

#include <gtest/gtest.h>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

std::string refusal(const std::string& text) {
  return errorTextOf([&] { tomlFrom(text, "a.toml"); });
}

TEST(TomlText, IsRead) {
  EXPECT_EQ(tomlFrom("[a]\nb = 2", "a.toml")["a"]["b"].value<int>(), 2);
  EXPECT_TRUE(tomlFrom("", "a.toml").empty());
}

TEST(TomlText, FaultsAreToldInPlainWordsWithTheirLine) {
  const std::string second = "a.toml, line 2: this is no TOML: ";
  EXPECT_EQ(refusal("a = 1\nb = [1 2]"), second + "a list that begins with [ has no comma or ]");
  EXPECT_EQ(refusal("a = 1\nb = {c = 1"), second + "a table that begins with { has no comma or }");
  EXPECT_EQ(refusal("a = 1\n[b"), second + "a head line is not [NAME]");
  EXPECT_EQ(refusal("a = 1\nb = \"c"),
            second + "a text in quotes has no end, or signs that it may not hold");
  EXPECT_EQ(refusal("a = 1\nb = 1.2.3"), second + "a number is not written as one");
  EXPECT_EQ(refusal("a = 1\nb = 99999999999999999999"), second + "a number is too large");
  EXPECT_EQ(refusal("a = 1\na = 2"), second + "a key or table stands twice");
  EXPECT_EQ(refusal("a = 1\nb = tru").rfind(second + "a value is none: allowed are numbers", 0),
            0u);
  EXPECT_EQ(refusal("a = 1\nb = maybe").rfind(second + "a value is none: allowed are numbers", 0),
            0u);
  EXPECT_EQ(refusal("a = 1\nb"), second + "it is not KEY = VALUE or [NAME]");
  EXPECT_EQ(refusal("a = 1\nb = \"\xff\""), second + "it has bytes that are no UTF-8 text");
}

}  // namespace
}  // namespace markerless_mocap
