#include "files/yaml_map.h"

#include <gtest/gtest.h>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

YamlMap mapOf(const std::string& text) {
  return YamlMap(YAML::Load(text), "a.yaml");
}

TEST(YamlMap, ReadsWhatIsThere) {
  YamlMap map = mapOf("{one: 1.5, some: [1, 2], inner: {two: 2}}");
  EXPECT_EQ(map.keys(), (std::vector<std::string>{"one", "some", "inner"}));
  EXPECT_EQ(map.number("one"), 1.5);
  EXPECT_EQ(map.numbers("some", 2, "x y"), (std::vector<double>{1, 2}));
  EXPECT_EQ(map.map("inner").number("two"), 2);
  EXPECT_FALSE(map.optional("three"));
  EXPECT_EQ(errorTextOf([&] { map.finish(); }), "");
}

TEST(YamlMap, KeysMustBeKnownAndThereOnce) {
  EXPECT_EQ(errorTextOf([] { mapOf("[1]"); }), "a.yaml: this is no map of keys to values");
  EXPECT_EQ(errorTextOf([] { mapOf("{one: 1, one: 2}"); }), "a.yaml: key 'one' is repeated");
  EXPECT_EQ(errorTextOf([] { mapOf("{[a]: 1}"); }), "a.yaml: this has a key that is no name");
  EXPECT_EQ(errorTextOf([] { mapOf("{one: 1}").number("two"); }), "a.yaml: key 'two' is missing");
  EXPECT_EQ(errorTextOf([] {
              YamlMap map = mapOf("{one: 1, three: 3}");
              map.number("one");
              map.optional("two");
              map.finish();
            }),
            "a.yaml: key 'three' is unknown, allowed are one, two");
}

TEST(YamlMap, NumbersMustBeFinite) {
  const auto faultOf = [](const std::string& value) {
    return errorTextOf([&] { mapOf("inner: {one: " + value + "}").map("inner").number("one"); });
  };
  EXPECT_EQ(faultOf("1"), "");
  EXPECT_EQ(faultOf(".inf"), "a.yaml, inner: 'one' holds .inf, allowed are finite numbers");
  EXPECT_EQ(faultOf("[1]"), "a.yaml, inner: 'one' holds a list or map, allowed are finite numbers");
  EXPECT_EQ(faultOf(""), "a.yaml, inner: 'one' holds nothing, allowed are finite numbers");
  EXPECT_EQ(errorTextOf([] { mapOf("some: 1").numbers("some"); }),
            "a.yaml: 'some' is no list of numbers");
  EXPECT_EQ(errorTextOf([] { mapOf("some: [1]").numbers("some", 2, "x y"); }),
            "a.yaml: 'some' has 1 numbers, wanted are 2: x y");
}

}  // namespace
}  // namespace markerless_mocap
