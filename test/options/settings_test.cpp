#include "options/settings.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

struct Sample {
  static constexpr const char* kStage = "stage";
  struct Filter {
    double cutoff = 1.5;
    void visit(OptionVisitor& v) { v.field("cutoff", cutoff, 0.1, 100, "Hz"); }
  };
  double pitch = 0.03;
  int views = 2;
  bool fast = false;
  std::string model = "one";
  std::vector<std::string> cameras;
  Eigen::Vector3d corner{1, 2, 3};
  double lower = -1, upper = 1;
  Filter filter;

  void visit(OptionVisitor& v) {
    v.field("pitch", pitch, 0.005, 0.2, "edge of a voxel, m");
    v.field("views", views, 2, 32, "cameras");
    v.field("fast", fast, "hurry");
    v.field("model", model, {"one", "two"}, "which");
    v.field("cameras", cameras, "names");
    v.field("corner", corner, -10, 10, "m");
    v.range("knee", lower, upper, -3, 3, "rad");
    v.section("filter", filter, "the filter");
  }
  void validate() const {
    checkFields(*this);
    if (views == 7) throw std::invalid_argument("stage/views is 7, nobody likes that");
  }
};

std::string refusal(const SettingChanges& changes) {
  return errorTextOf([&] { withChanges(Sample(), {"model"}, changes); });
}

TEST(Settings, AreListedAsTheOptionsAre) {
  const std::vector<Setting> settings = settingsOf(Sample(), {"model"});
  std::string names;
  for (const Setting& setting : settings) names += setting.name + " ";
  EXPECT_EQ(names, "pitch views fast corner_x corner_y corner_z knee_min knee_max filter_cutoff ");
  EXPECT_EQ(settings[0].meaning, "edge of a voxel, m");
  EXPECT_EQ(settings[0].min_value, 0.005);
  EXPECT_EQ(settings[0].max_value, 0.2);
  EXPECT_EQ(std::get<double>(settings[4].value), 2.0);
  EXPECT_EQ(std::get<double>(settings.back().value), 1.5);
}

TEST(Settings, ASectionCanBeFixedAndAWordBeFree) {
  const std::vector<Setting> settings = settingsOf(Sample(), {"filter", "knee", "corner"});
  ASSERT_EQ(settings.size(), 4u);
  EXPECT_EQ(settings.back().allowed, (std::vector<std::string>{"one", "two"}));
}

TEST(Settings, WhatIsFixedStaysWhenAllOtherOptionsAreReplaced) {
  Sample current;
  current.model = "two";
  current.cameras = {"a"};
  current.corner.x() = 5;
  current.lower = -2;
  current.filter.cutoff = 7;
  Sample other;
  other.pitch = 0.1;
  const Sample all = withFixed(other, current, {"model", "cameras", "corner", "knee", "filter"});
  EXPECT_EQ(all.model, "two");
  EXPECT_EQ(all.cameras, current.cameras);
  EXPECT_EQ(all.corner, current.corner);
  EXPECT_EQ(all.lower, -2);
  EXPECT_EQ(all.filter.cutoff, 7);
  EXPECT_EQ(all.pitch, 0.1);
  const Sample none = withFixed(other, current, {"cutoff"});  // that of no section
  EXPECT_EQ(none.model, "one");
  EXPECT_EQ(none.filter.cutoff, 1.5);
  EXPECT_EQ(withFixed(other, current, {"filter/cutoff"}).filter.cutoff, 7);
}

TEST(Settings, ChangesReachTheirMembersAndNoOthers) {
  const Sample changed = withChanges(Sample(), {"model"},
                                     {{"pitch", 0.1},
                                      {"views", 3},
                                      {"fast", true},
                                      {"corner_y", 5.0},
                                      {"knee_max", 2},  // a whole number is a number
                                      {"filter_cutoff", 4.0}});
  EXPECT_EQ(changed.pitch, 0.1);
  EXPECT_EQ(changed.views, 3);
  EXPECT_TRUE(changed.fast);
  EXPECT_EQ(changed.corner, Eigen::Vector3d(1, 5, 3));
  EXPECT_EQ(changed.lower, -1.0);
  EXPECT_EQ(changed.upper, 2.0);
  EXPECT_EQ(changed.filter.cutoff, 4.0);
}

TEST(Settings, WhatIsNotAllowedIsRefusedWithTheLoadersSentence) {
  EXPECT_EQ(refusal({{"pitch", 0.5}}), "stage/pitch is 0.5, allowed is 0.005 to 0.2");
  EXPECT_EQ(refusal({{"views", 2.5}}), "stage/views is 2.5, allowed is a whole number, 2 to 32");
  EXPECT_EQ(refusal({{"fast", std::string("yes")}}),
            "stage/fast is \"yes\", allowed is true or false");
  EXPECT_EQ(refusal({{"filter_cutoff", 0.0}}), "stage/filter/cutoff is 0, allowed is 0.1 to 100");
  EXPECT_EQ(refusal({{"knee_min", 2.0}}),
            "stage/knee is [2, 1], allowed is [min, max] with a min that is not greater than max");
  EXPECT_EQ(refusal({{"views", 7}}), "stage/views is 7, nobody likes that");
}

TEST(Settings, WhatIsNoSettingIsRefused) {
  EXPECT_EQ(refusal({{"pich", 0.1}}),
            "stage has no setting pich that can be changed while it runs");
  EXPECT_EQ(refusal({{"model", std::string("two")}}),
            "stage has no setting model that can be changed while it runs");
}

}  // namespace
}  // namespace markerless_mocap
