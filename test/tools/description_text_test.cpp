#include "tools/common/description_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace markerless_mocap {
namespace {

MotionDescription twoSteps() {
  const Average unknown{0, NAN, NAN, NAN};
  MotionDescription motion;
  motion.seconds = 2.5;
  motion.frames = 76;
  motion.frames_with_pose = 70;
  motion.steps = {
      {true, 0.5, {0.61, 0.004}, {0.09, 0.004}, {NAN, NAN}, {0.7, 0.03}},
      {false, 1.1, {0.65, 0.004}, {-0.01, 0.004}, {0.6, 0.04}, {NAN, NAN}},
  };
  motion.cadence_per_min = {1, 100.0, 0.0, 6.7};
  motion.length_m = {2, 0.63, 0.02, 0.004};
  motion.width_m = {2, 0.04, 0.05, 0.004};
  motion.contact_s = {1, 0.7, 0.0, 0.03};
  motion.left_length_m = motion.right_length_m = motion.left_contact_s = motion.right_contact_s =
      unknown;
  motion.lean = {{70, 2.25, 1.0, 0.5}, {70, -1.0, 1.0, NAN}, 1.0, 4.0, -3.0, 0.0};
  motion.ranges = {{"l_knee", -60.0, -5.0, {55.0, 0.8}}, {"l_ankle", 0.0, 20.0, {20.0, NAN}}};
  return motion;
}

TEST(DescriptionText, TableHasErrorsWhereTheyAreKnown) {
  std::ostringstream out;
  printDescription(twoSteps(), out);
  EXPECT_EQ(out.str(),
            "2.5 s, 70 of 76 frames with a pose; ± is the expected error\n"
            "steps: 2\n"
            "  cadence         100.0 ± 6.7 per minute, 0.0 between 1\n"
            "  length          63.0 ± 0.4 cm, 2.0 between 2\n"
            "  width           4.0 ± 0.4 cm, 5.0 between 2\n"
            "  contact         700 ± 30 ms, 0 between 1\n"
            "trunk lean\n"
            "  forward         2.2 ± 0.5°, from 1.0° to 4.0°\n"
            "  left            -1.0°, from -3.0° to 0.0°\n"
            "ranges of motion (percentiles 1 to 99)\n"
            "  l_knee          55.0 ± 0.8°, from -60.0° to -5.0°\n"
            "  l_ankle         20.0°, from 0.0° to 20.0°\n");
}

TEST(DescriptionText, JsonHoldsEveryValueWithItsError) {
  const auto json = nlohmann::json::parse(descriptionJson(twoSteps()));
  EXPECT_EQ(json["frames_with_pose"], 70);
  ASSERT_EQ(json["steps"].size(), 2u);
  EXPECT_EQ(json["steps"][0]["foot"], "left");
  EXPECT_EQ(json["steps"][1]["width_m"]["value"], -0.01);
  EXPECT_EQ(json["steps"][1]["step_s"]["expected_error"], 0.04);
  EXPECT_TRUE(json["steps"][0]["step_s"]["value"].is_null());
  EXPECT_EQ(json["step_length_m"]["mean"], 0.63);
  EXPECT_EQ(json["step_length_m"]["expected_error"], 0.004);
  EXPECT_TRUE(json["step_length_left_m"]["mean"].is_null());
  EXPECT_EQ(json["trunk_lean_forward_deg"]["high"], 4.0);
  EXPECT_TRUE(json["trunk_lean_left_deg"]["expected_error"].is_null());
  EXPECT_EQ(json["ranges"]["l_knee"]["range_deg"]["value"], 55.0);
  EXPECT_EQ(json["ranges"]["l_knee"]["low_deg"], -60.0);
}

}  // namespace
}  // namespace markerless_mocap
