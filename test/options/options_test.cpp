#include "markerless_mocap/options/options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include "error_text_of.h"

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

  void visit(OptionVisitor& v) {
    v.field("pitch", pitch, 0.005, 0.2, "edge of a voxel, m");
    v.field("views", views, 2, 32, "cameras");
    v.field("color", color, "use colour");
    v.field("method", method, {"walk", "tree"}, "how");
    v.field("cameras", cameras, "names");
    v.field("corner", corner, -10, 10, "m");
  }
  void validate() const { checkFields(*this); }
};

SampleOptions load(const std::string& yaml) {
  return loadOptions<SampleOptions>(YAML::Load(yaml));
}

/// The sentence a YAML text is refused with, or "" if it is taken.
std::string refusal(const std::string& yaml) {
  return errorTextOf([&] { load(yaml); });
}

TEST(Options, EmptyMapKeepsDefaults) {
  const SampleOptions options = load("");
  EXPECT_EQ(options.pitch, 0.03);
  EXPECT_EQ(options.method, "walk");
}

TEST(Options, EveryTypeIsRead) {
  const SampleOptions o = load(
      "{pitch: 0.05, views: 4, color: false, method: tree, cameras: [a, b], corner: [1, -2, 3]}");
  EXPECT_EQ(o.pitch, 0.05);
  EXPECT_EQ(o.views, 4);
  EXPECT_FALSE(o.color);
  EXPECT_EQ(o.method, "tree");
  EXPECT_EQ(o.cameras, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(o.corner, Eigen::Vector3d(1, -2, 3));
}

TEST(Options, ValueOutOfRangeNamesKeyValueAndRange) {
  EXPECT_EQ(refusal("pitch: 0.5"), "sample/pitch is 0.5, allowed is 0.005 to 0.2");
  EXPECT_EQ(refusal("pitch: .nan"), "sample/pitch is nan, allowed is 0.005 to 0.2");
  EXPECT_EQ(refusal("views: 1"), "sample/views is 1, allowed is 2 to 32");
  EXPECT_EQ(refusal("method: swim"), "sample/method is \"swim\", allowed is one of walk, tree");
}

TEST(Options, WrongTypeNamesKeyValueAndType) {
  EXPECT_EQ(refusal("views: two"), "sample/views is two, allowed is a whole number, 2 to 32");
  EXPECT_EQ(refusal("views: 2.5"), "sample/views is 2.5, allowed is a whole number, 2 to 32");
  EXPECT_EQ(refusal("pitch: [1]"), "sample/pitch is [1], allowed is a number, 0.005 to 0.2");
  EXPECT_EQ(refusal("corner: [1, 2]"),
            "sample/corner is [1, 2], allowed is three numbers, each -10 to 10");
  EXPECT_EQ(refusal("[1, 2]"), "sample is [1, 2], allowed is a map of keys to values");
}

TEST(Options, UnknownKeyNamesTheNearestOne) {
  EXPECT_EQ(refusal("pich: 0.02"),
            "sample/pich is not an option (value 0.02), did you mean pitch?");
}

TEST(Options, CheckFieldsFindsValuesSetInCode) {
  SampleOptions options;
  options.pitch = std::nan("");
  EXPECT_THROW(options.validate(), std::invalid_argument);
  options.pitch = 0.03;
  EXPECT_NO_THROW(options.validate());
}

TEST(Options, DescriberWritesOneRowPerField) {
  OptionDescriber describer;
  SampleOptions options;
  options.visit(describer);
  const std::string rows = describer.rows();
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 6);
  EXPECT_NE(rows.find("| `pitch` | 0.03 | 0.005 to 0.2 | edge of a voxel, m |"), std::string::npos);
}

/// The fields of two structs in one section.
struct TwinOptions {
  static constexpr const char* kStage = "twins";
  SampleOptions one, other;

  void visit(OptionVisitor& v) {
    one.visit(v);
    PrefixedVisitor of_other("other_", v);
    other.visit(of_other);
  }
  void validate() const { checkFields(*this); }
};

TEST(PrefixedVisitor, EveryTypeIsReadUnderThePrefix) {
  const TwinOptions o = loadOptions<TwinOptions>(
      YAML::Load("{pitch: 0.02, other_pitch: 0.05, other_views: 4, other_color: false, "
                 "other_method: tree, other_cameras: [a], other_corner: [1, 2, 3]}"));
  EXPECT_EQ(o.one.pitch, 0.02);
  EXPECT_EQ(o.one.views, 2);
  EXPECT_EQ(o.other.pitch, 0.05);
  EXPECT_EQ(o.other.views, 4);
  EXPECT_FALSE(o.other.color);
  EXPECT_EQ(o.other.method, "tree");
  EXPECT_EQ(o.other.cameras, std::vector<std::string>{"a"});
  EXPECT_EQ(o.other.corner, Eigen::Vector3d(1, 2, 3));
}

TEST(PrefixedVisitor, RefusalsNameTheWholeKey) {
  const auto refused = [](const std::string& yaml) {
    return errorTextOf([&] { loadOptions<TwinOptions>(YAML::Load(yaml)); });
  };
  EXPECT_EQ(refused("other_pitch: 0.5"), "twins/other_pitch is 0.5, allowed is 0.005 to 0.2");
  EXPECT_EQ(refused("other_corner: [1]"),
            "twins/other_corner is [1], allowed is three numbers, each -10 to 10");
  EXPECT_EQ(refused("other_views: x"),
            "twins/other_views is x, allowed is a whole number, 2 to 32");
  EXPECT_EQ(refused("other_pich: 0.1"),
            "twins/other_pich is not an option (value 0.1), did you mean other_pitch?");
}

TEST(PrefixedVisitor, CheckerAndDescriberSeeTheWholeKeyToo) {
  TwinOptions options;
  options.other.method = "swim";
  EXPECT_EQ(errorTextOf([&] { options.validate(); }),
            "twins/other_method is \"swim\", allowed is one of walk, tree");
  OptionDescriber describer;
  PrefixedVisitor outer("a_", describer), inner("b_", outer);
  SampleOptions().visit(inner);
  EXPECT_NE(describer.rows().find("| `a_b_views` | 2 | 2 to 32 | cameras |"), std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
