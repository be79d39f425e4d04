#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "error_text_of.h"
#include "nodes/silhouette/timed_settings.h"
#include "ros/package_files.h"
#include "ros/settings_conversions.h"
#include "ros/volume_file.h"

namespace markerless_mocap {
namespace {

using Settings = TimedSettings<int>;
constexpr int64_t kPeriod = 100'000'000, kSkew = 3'000'000;  // ns

TEST(TimedSettings, CamerasChangeFromTheSameFrameSetOn) {
  Settings settings(2, 1);
  for (int64_t t = 0; t <= 5; ++t) EXPECT_EQ(*settings.at(0, t * kPeriod), 1);
  EXPECT_EQ(*settings.at(1, kSkew), 1);
  settings.change(2);
  // The second camera is behind, and its stamps are a little later than the first one's.
  for (int64_t t = 1; t <= 5; ++t) EXPECT_EQ(*settings.at(1, t * kPeriod + kSkew), 1);
  EXPECT_EQ(*settings.at(0, 6 * kPeriod), 2);
  EXPECT_EQ(*settings.at(1, 6 * kPeriod - kSkew), 2);
}

TEST(TimedSettings, WhoIsBehindGetsEachChangeInItsTime) {
  Settings settings(2, 1);
  settings.at(1, 0);
  for (int64_t t = 0; t <= 2; ++t) settings.at(0, t * kPeriod);
  settings.change(2);
  settings.at(0, 3 * kPeriod);
  settings.change(3);
  EXPECT_EQ(*settings.at(1, 2 * kPeriod), 1);
  EXPECT_EQ(*settings.at(1, 3 * kPeriod), 2);
  EXPECT_EQ(*settings.at(1, 4 * kPeriod), 3);
}

TEST(TimedSettings, BeforeTheFirstImageAndAfterAStepBackTheLastOnesHold) {
  Settings settings(1, 1);
  settings.change(2);
  EXPECT_EQ(*settings.at(0, 100 * kPeriod), 2);
  settings.change(3);
  EXPECT_EQ(*settings.at(0, kPeriod), 3);  // the bag begins again
}

// Free-running cameras: their stamps lie all over a period.
TEST(TimedSettings, CamerasOutOfStepChangeOncePerPeriod) {
  Settings settings(3, 0);
  for (int64_t t = 0; t <= 10; ++t) {
    settings.change(int(t));
    for (size_t camera = 0; camera < 3; ++camera) {
      const int64_t stamp_ns = t * kPeriod + int64_t(camera) * kPeriod / 3;
      EXPECT_EQ(*settings.at(camera, stamp_ns), int(t)) << camera;
    }
  }
}

TEST(TimedSettings, ACameraThatLostAnImageDoesNotStayBehind) {
  Settings settings(2, 1);
  for (int64_t t = 0; t <= 2; ++t)
    for (size_t camera = 0; camera < 2; ++camera) settings.at(camera, t * kPeriod);
  settings.at(0, 3 * kPeriod);  // the other one has lost its image
  settings.change(2);
  EXPECT_EQ(*settings.at(1, 4 * kPeriod), 2);
  EXPECT_EQ(*settings.at(0, 4 * kPeriod), 2);
}

TEST(SettingsMessages, DescribeTypeRangeAndWords) {
  const auto description = messageFromSettings(settingsOf(HullOptions(), {}));
  ASSERT_EQ(description.groups.size(), 1u);
  const auto& parameters = description.groups[0].parameters;
  EXPECT_EQ(parameters[0].name, "volume_min_x");
  EXPECT_EQ(parameters[0].type, "double");
  EXPECT_EQ(parameters[6].name, "volume");
  EXPECT_EQ(parameters[6].type, "str");
  EXPECT_EQ(parameters[6].edit_method,
            "{'enum': [{'name': 'auto', 'value': 'auto', 'type': 'str', 'description': ''}, "
            "{'name': 'explicit', 'value': 'explicit', 'type': 'str', 'description': ''}], "
            "'enum_description': ''}");
  const auto at = [](const auto& values, const std::string& name) {
    for (const auto& v : values)
      if (v.name == name) return v.value;
    throw std::runtime_error("no " + name);
  };
  EXPECT_EQ(at(description.min.doubles, "pitch"), 0.005);
  EXPECT_EQ(at(description.max.doubles, "pitch"), 0.2);
  EXPECT_EQ(at(description.dflt.doubles, "pitch"), HullOptions().pitch);
  EXPECT_EQ(at(description.max.ints, "min_views"), 32);
  EXPECT_TRUE(at(description.max.bools, "cut_at_floor"));
  // Clients look every setting up in all three.
  const size_t all = parameters.size();
  for (const auto* c : {&description.min, &description.max, &description.dflt})
    EXPECT_EQ(c->bools.size() + c->ints.size() + c->doubles.size() + c->strs.size(), all);
}

TEST(SettingsMessages, ValuesComeBackAsChanges) {
  HullOptions options;
  options.pitch = 0.05;
  options.volume = "auto";
  options.min_views = 4;
  options.cut_at_floor = true;
  const auto message = valuesMessage(settingsOf(options, {}));
  const HullOptions back = withChanges(HullOptions(), {}, changesFromMessage(message));
  EXPECT_EQ(back.pitch, 0.05);
  EXPECT_EQ(back.volume, "auto");
  EXPECT_EQ(back.min_views, 4);
  EXPECT_TRUE(back.cut_at_floor);
}

class VolumeFile : public testing::Test {
 protected:
  void TearDown() override { std::remove(file_.c_str()); }
  std::string refusal(const std::string& text) {
    writeText(file_, text);
    return errorTextOf([&] { withVolumeOf(file_, HullOptions()); });
  }
  const std::string file_ = testing::TempDir() + "live_settings_volume.yaml";
};

TEST_F(VolumeFile, KeepsTheVolumeAndNothingElse) {
  HullOptions options;
  options.volume = "explicit";
  options.volume_min = {-1.25, -2, 0.1};
  options.volume_max = {3, 2.5, 2};
  options.pitch = 0.05;
  writeText(file_, volumeText(options));
  const HullOptions read = withVolumeOf(file_, HullOptions());
  EXPECT_EQ(read.volume, "explicit");
  EXPECT_EQ(read.volume_min, options.volume_min);
  EXPECT_EQ(read.volume_max, options.volume_max);
  EXPECT_EQ(read.pitch, HullOptions().pitch);
}

TEST_F(VolumeFile, RefusesOtherFilesByTheirName) {
  EXPECT_EQ(refusal("{visual_hull: {pitch: 0.1}}").rfind(file_ + "/visual_hull/pitch is not", 0),
            0u);
  EXPECT_EQ(refusal("{silhouette: {}}").rfind(file_ + "/silhouette is not an option", 0), 0u);
  EXPECT_EQ(refusal("{visual_hull: [").rfind(file_ + " is no YAML", 0), 0u);
  EXPECT_EQ(refusal("{visual_hull: {volume_min: [9, 0, 0]}}"),
            "visual_hull/volume_min is not below volume_max along x");
}

}  // namespace
}  // namespace markerless_mocap
