#include "fleischmann/fleischmann_motion_statistics.h"

#include <gtest/gtest.h>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

TEST(FleischmannMotionStatistics, keepsTheLargestChangeOfEachParameterAtSixtyFrames) {
  FleischmannMotionStatistics statistics;
  FleischmannVector a = FleischmannVector::Zero(), b = a, c = a;
  b[3] = 0.02;
  b[9] = -0.06;
  statistics.add(a, b, 1.0 / 60);
  c[3] = 0.05;  // 0.03 on from b in 1/30 s
  c[9] = -0.16;
  statistics.add(b, c, 1.0 / 30);
  EXPECT_NEAR(statistics.max_change[3], 0.02, 1e-12);
  EXPECT_NEAR(statistics.max_change[9], 0.06, 1e-12);
  EXPECT_EQ(statistics.max_change[0], 0.0);
  EXPECT_NEAR(statistics.over(1.0 / 20)[3], 0.06, 1e-12);
  EXPECT_EQ(errorTextOf([&] { statistics.add(a, b, 0.0); }),
            "motion statistics: the time between two frames must be positive");
}

TEST(FleischmannMotionStatistics, readsWhatItWrites) {
  FleischmannMotionStatistics statistics;
  for (int d = 0; d < kFleischmannParameterCount; ++d) statistics.max_change[d] = 0.001 * d;
  const FleischmannMotionStatistics read =
      FleischmannMotionStatistics::fromYaml(statistics.toYaml());
  EXPECT_LT((read.max_change - statistics.max_change).norm(), 1e-12);
}

TEST(FleischmannMotionStatistics, sentencesNameTheParameter) {
  const std::string text = FleischmannMotionStatistics().toYaml();
  const auto refused = [](const std::string& yaml) {
    return errorTextOf([&] { FleischmannMotionStatistics::fromYaml(yaml); });
  };
  EXPECT_EQ(refused(text + "left_wing: 0.1\n"), "motion statistics: unknown parameter left_wing");
  EXPECT_EQ(refused("pelvis_roll: 0.1\n"), "motion statistics: pelvis_pitch is missing");
  EXPECT_EQ(refused(text + "? [a, b]\n: 1\n"),
            "motion statistics: its keys must be names of parameters");
  EXPECT_EQ(refused("3"), "motion statistics: a map from parameters to values is needed");
  std::string negative = text;
  negative.replace(negative.find("left_knee: 0.00000"), 18, "left_knee: -1");
  EXPECT_EQ(refused(negative),
            "motion statistics: left_knee must be a number of at least 0 (maximum change "
            "between frames)");
  std::string word = text;
  word.replace(word.find("left_knee: 0.00000"), 18, "left_knee: fast");
  EXPECT_EQ(refused(word), refused(negative));
}

}  // namespace
}  // namespace markerless_mocap
