#include "markerless_mocap/options/options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "error_text_of.h"
#include "option_list.h"

namespace markerless_mocap {
namespace {

struct SampleOptions {
  static constexpr const char* kStage = "sample";
  double pitch = 0.03;
  int views = 2;
  bool color = true;
  std::string method = "walk";
  std::vector<std::string> cameras;
  Eigen::Vector3d corner{0, 0, 0};
  double lower = -1, upper = 1;

  void visit(OptionVisitor& v) {
    v.field("pitch", pitch, 0.005, 0.2, "edge of a voxel, m");
    v.field("views", views, 2, 1000000000, "cameras");
    v.field("color", color, "use colour");
    v.field("method", method, {"walk", "tree"}, "how");
    v.field("cameras", cameras, "names");
    v.field("corner", corner, -10, 10, "m");
    v.range("knee", lower, upper, -3, 3, "rad");
  }
  void validate() const { checkFields(*this); }
};

/// A struct with sections, one within the other.
struct OuterOptions {
  static constexpr const char* kStage = "outer";
  struct Middle {
    int count = 1;
    SampleOptions sample;
    void visit(OptionVisitor& v) {
      v.field("count", count, 0, 9, "how many");
      v.section("sample", sample, "the innermost");
    }
  } middle;
  int count = 2;

  void visit(OptionVisitor& v) {
    v.field("count", count, 0, 9, "how many");
    v.section("middle", middle, "the one between");
  }
  void validate() const { checkFields(*this); }
};

template <class OptionsT>
OptionsT read(const std::string& yaml) {
  return loadOptions<OptionsT>(YAML::Load(yaml));
}

/// The error of a YAML text, or "".
template <class OptionsT = SampleOptions>
std::string errorOf(const std::string& yaml) {
  return errorTextOf([&] { read<OptionsT>(yaml); });
}

TEST(Options, EmptyMapKeepsDefaults) {
  EXPECT_EQ(valuesOf(read<SampleOptions>("")), valuesOf(SampleOptions()));
  EXPECT_EQ(valuesOf(read<OuterOptions>("{middle: {sample: }}")), valuesOf(OuterOptions()));
}

TEST(Options, EveryTypeIsRead) {
  const auto o = read<SampleOptions>(
      "{pitch: 0.05, views: 4, color: false, method: tree, cameras: [a, b], corner: [1, -2, 3], "
      "knee: [0, 2.5]}");
  EXPECT_EQ(o.pitch, 0.05);
  EXPECT_EQ(o.views, 4);
  EXPECT_FALSE(o.color);
  EXPECT_EQ(o.method, "tree");
  EXPECT_EQ(o.cameras, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(o.corner, Eigen::Vector3d(1, -2, 3));
  EXPECT_EQ(o.lower, 0.0);
  EXPECT_EQ(o.upper, 2.5);
}

TEST(Options, ValueOutOfRangeNamesKeyValueAndRange) {
  EXPECT_EQ(errorOf("pitch: 0.5"), "sample/pitch is 0.5, allowed is 0.005 to 0.2");
  EXPECT_EQ(errorOf("pitch: .nan"), "sample/pitch is nan, allowed is 0.005 to 0.2");
  EXPECT_EQ(errorOf("views: 1"), "sample/views is 1, allowed is 2 to 1000000000");
  EXPECT_EQ(errorOf("method: swim"), "sample/method is \"swim\", allowed is one of walk, tree");
  EXPECT_EQ(errorOf("corner: [1, .nan, 2]"),
            "sample/corner is [1, nan, 2], allowed is three numbers, each -10 to 10");
  EXPECT_EQ(errorOf("corner: [1, 2, 11]"),
            "sample/corner is [1, 2, 11], allowed is three numbers, each -10 to 10");
}

TEST(Options, WrongTypeNamesKeyValueAndType) {
  EXPECT_EQ(errorOf("views: two"),
            "sample/views is two, allowed is a whole number, 2 to 1000000000");
  EXPECT_EQ(errorOf("views: 2.5"),
            "sample/views is 2.5, allowed is a whole number, 2 to 1000000000");
  EXPECT_EQ(errorOf("pitch: [1]"), "sample/pitch is [1], allowed is a number, 0.005 to 0.2");
  EXPECT_EQ(errorOf("pitch: {a: 1}"), "sample/pitch is {a: 1}, allowed is a number, 0.005 to 0.2");
  EXPECT_EQ(errorOf("color: 3"), "sample/color is 3, allowed is true or false");
  EXPECT_EQ(errorOf("cameras: a"), "sample/cameras is a, allowed is a list of texts");
  EXPECT_EQ(errorOf("method: [walk]"), "sample/method is [walk], allowed is one of walk, tree");
  EXPECT_EQ(errorOf("corner: [1, 2]"),
            "sample/corner is [1, 2], allowed is three numbers, each -10 to 10");
  EXPECT_EQ(errorOf("[1, 2]"), "sample is [1, 2], allowed is a map of keys to values");
}

TEST(Options, RangeIsAPairInOrder) {
  EXPECT_EQ(errorOf("knee: 1"), "sample/knee is 1, allowed is [min, max], each -3 to 3");
  EXPECT_EQ(errorOf("knee: [1]"), "sample/knee is [1], allowed is [min, max], each -3 to 3");
  EXPECT_EQ(errorOf("knee: [1, 2, 3]"),
            "sample/knee is [1, 2, 3], allowed is [min, max], each -3 to 3");
  EXPECT_EQ(errorOf("knee: [-4, 0]"),
            "sample/knee is [-4, 0], allowed is [min, max], each -3 to 3");
  EXPECT_EQ(errorOf("knee: [0, .nan]"),
            "sample/knee is [0, nan], allowed is [min, max], each -3 to 3");
  EXPECT_EQ(
      errorOf("knee: [1, 0.5]"),
      "sample/knee is [1, 0.5], allowed is [min, max] with a min that is not greater than max");
  EXPECT_EQ(errorOf("knee: [1, 1]"), "");
}

TEST(Options, OfLongTextsTheBeginningIsShown) {
  const std::string letters(200000, 'x');
  EXPECT_EQ(errorOf("method: " + letters),
            "sample/method is \"" + letters.substr(0, 99) + " ..., allowed is one of walk, tree");
  const std::string unknown = errorOf("? " + letters + "\n: 1");
  EXPECT_EQ(unknown.find("sample/" + letters.substr(0, 100) + " ... is not an option"), 0u)
      << unknown;
  std::string umlauts = "x";
  for (int i = 0; i < 100; ++i) umlauts += "\xC3\xBC";
  EXPECT_EQ(errorOf("views: " + umlauts), "sample/views is " + umlauts.substr(0, 99) +
                                              " ..., allowed is a whole number, 2 to 1000000000");
}

TEST(Options, UnknownKeyNamesTheNearestOne) {
  EXPECT_EQ(errorOf("pich: 0.02"),
            "sample/pich is not an option (value 0.02), did you mean pitch?");
}

TEST(Options, KeyThatIsNoTextIsNamed) {
  EXPECT_EQ(errorOf("? [a, b]\n: 1"), "sample has the key [a, b], allowed are texts");
  EXPECT_EQ(errorOf("? {a: b}\n: 1"), "sample has the key {a: b}, allowed are texts");
  EXPECT_EQ(errorOf("~: 1"), "sample has the key ~, allowed are texts");
  EXPECT_EQ(errorOf<OuterOptions>("middle: {? [a, b] : 1}"),
            "outer/middle has the key [a, b], allowed are texts");
}

TEST(Options, CheckFieldsFindsValuesSetInCode) {
  SampleOptions options;
  options.pitch = std::nan("");
  EXPECT_EQ(errorTextOf([&] { options.validate(); }),
            "sample/pitch is nan, allowed is 0.005 to 0.2");
  options.pitch = 0.03;
  EXPECT_NO_THROW(options.validate());
  options.lower = 2;
  EXPECT_NE(errorTextOf([&] { options.validate(); }).find("sample/knee is [2, 1]"),
            std::string::npos);
}

TEST(OptionSections, AreReadAtAnyDepth) {
  const auto o =
      read<OuterOptions>("{count: 3, middle: {count: 4, sample: {pitch: 0.1, knee: [0, 1]}}}");
  EXPECT_EQ(o.count, 3);
  EXPECT_EQ(o.middle.count, 4);
  EXPECT_EQ(o.middle.sample.pitch, 0.1);
  EXPECT_EQ(o.middle.sample.lower, 0.0);
  EXPECT_EQ(o.middle.sample.views, 2);
}

TEST(OptionSections, ErrorsNameTheWholePath) {
  EXPECT_EQ(errorOf<OuterOptions>("{middle: {sample: {pitch: 1}}}"),
            "outer/middle/sample/pitch is 1, allowed is 0.005 to 0.2");
  EXPECT_EQ(errorOf<OuterOptions>("{middle: {count: many}}"),
            "outer/middle/count is many, allowed is a whole number, 0 to 9");
  EXPECT_EQ(errorOf<OuterOptions>("{middle: 3}"),
            "outer/middle is 3, allowed is a map of keys to values");
  EXPECT_EQ(errorOf<OuterOptions>("{middle: [3]}"),
            "outer/middle is [3], allowed is a map of keys to values");
}

TEST(OptionSections, UnknownKeyNamesTheNearestOfItsOwnSection) {
  EXPECT_EQ(errorOf<OuterOptions>("{middle: {pitch: 0.1}}"),
            "outer/middle/pitch is not an option (value 0.1), did you mean count?");
  EXPECT_EQ(errorOf<OuterOptions>("{middle: {sample: {viws: 1}}}"),
            "outer/middle/sample/viws is not an option (value 1), did you mean views?");
  EXPECT_EQ(errorOf<OuterOptions>("{midle: {count: 1}}"),
            "outer/midle is not an option (value {count: 1}), did you mean middle?");
}

TEST(OptionSections, CheckerNamesTheWholePath) {
  OuterOptions options;
  options.middle.sample.method = "swim";
  EXPECT_EQ(errorTextOf([&] { options.validate(); }),
            "outer/middle/sample/method is \"swim\", allowed is one of walk, tree");
}

}  // namespace
}  // namespace markerless_mocap
