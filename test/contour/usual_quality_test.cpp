#include "contour/track/usual_quality.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

TEST(UsualQuality, EverythingIsUsualUntilSomeAreKnown) {
  UsualQuality usual;
  for (int i = 0; i < 9; ++i) usual.add(0.97);
  EXPECT_TRUE(usual.includes(0.5));
  usual.add(0.97);
  EXPECT_FALSE(usual.includes(0.5));
  usual.forget();
  EXPECT_TRUE(usual.includes(0.5));
}

TEST(UsualQuality, TwoAndAHalfDeviationsBelowTheMeanAreUsual) {
  UsualQuality usual;
  for (int i = 0; i < 2000; ++i) usual.add(i % 2 ? 0.96 : 0.94);  // deviation 0.01
  EXPECT_TRUE(usual.includes(0.95 - 0.023));
  EXPECT_FALSE(usual.includes(0.95 - 0.027));
  EXPECT_TRUE(usual.includes(1.0)) << "a better fit is welcome";
}

TEST(UsualQuality, OfEqualQualitiesSmallDifferencesAreUsual) {
  UsualQuality usual;
  for (int i = 0; i < 20; ++i) usual.add(0.98);
  EXPECT_TRUE(usual.includes(0.976));
  EXPECT_FALSE(usual.includes(0.974));
}

TEST(UsualQuality, NearIsWhatNoOtherPlaceOfALimbExplains) {
  UsualQuality usual;
  EXPECT_TRUE(usual.isNear(0.5));
  for (int i = 0; i < 20; ++i) usual.add(0.97);
  EXPECT_TRUE(usual.isNear(0.95));
  EXPECT_FALSE(usual.isNear(0.93));
}

TEST(UsualQuality, FollowsARoomThatChanges) {
  UsualQuality usual;
  for (int i = 0; i < 50; ++i) usual.add(0.98);
  EXPECT_FALSE(usual.includes(0.90));
  for (int i = 0; i < 200; ++i) usual.add(0.90);
  EXPECT_TRUE(usual.includes(0.895));
  EXPECT_FALSE(usual.includes(0.85));
}

TEST(UsualQuality, FarBelowIsNeverUsualForSomeSeconds) {
  constexpr int64_t kFrame_ns = 100000000, kSecond_ns = 1000000000;
  UsualQuality usual;
  int64_t now = 0;
  EXPECT_FALSE(usual.isFarAbove(now, 0.5)) << "nothing is known";
  for (int i = 0; i < 50; ++i) usual.add(i % 2 ? 0.97 : 0.96);
  EXPECT_FALSE(usual.isFarAbove(now, 0.90));
  for (; now < 9 * kSecond_ns; now += kFrame_ns) ASSERT_TRUE(usual.isFarAbove(now, 0.7)) << now;
  EXPECT_FALSE(usual.isFarAbove(now += kFrame_ns, 0.965));
  const int64_t begin = now;
  for (; now < begin + 9 * kSecond_ns; now += kFrame_ns)
    ASSERT_TRUE(usual.isFarAbove(now, 0.7)) << "the time counts anew";
  EXPECT_FALSE(usual.isFarAbove(now += 2 * kSecond_ns, 0.7));
  EXPECT_TRUE(usual.includes(0.7)) << "it has become another room";
}

}  // namespace
}  // namespace markerless_mocap
