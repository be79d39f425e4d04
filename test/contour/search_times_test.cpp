#include "contour/track/search_times.h"

#include <gtest/gtest.h>

#include "contour/track/start_schedule.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kMs = 1000000;

TEST(SearchTimesTest, AreTheSameWheneverTheTrackerWasStarted) {
  SearchTimer early(100 * kMs), late(100 * kMs);
  early.done(10 * kMs);
  late.done(90 * kMs);
  for (SearchTimer* one : {&early, &late}) {
    EXPECT_FALSE(one->isDue(99 * kMs));
    EXPECT_TRUE(one->isDue(100 * kMs));
  }
}

TEST(SearchTimesTest, GrowWithoutSuccess) {
  PatientSearchTimer timer(100 * kMs, 400 * kMs);
  EXPECT_TRUE(timer.isDue(0));
  for (int64_t expected : {100, 200, 400, 400}) {
    timer.done(0, false);
    EXPECT_FALSE(timer.isDue(expected * kMs - 1));
    EXPECT_TRUE(timer.isDue(expected * kMs));
  }
  timer.done(0, true);
  EXPECT_TRUE(timer.isDue(100 * kMs));
}

TEST(StartScheduleTest, RestsTheLongerTheLongerNobodyIsFound) {
  StartSchedule starts;
  starts.noteHull(0, true);
  starts.startBegins(1000 * kMs, false);
  EXPECT_TRUE(starts.rests(1199 * kMs));
  EXPECT_FALSE(starts.rests(1200 * kMs));
  starts.startBegins(60000 * kMs, false);
  EXPECT_FALSE(starts.rests(60400 * kMs));
}

TEST(StartScheduleTest, DoesNotRestForSomebodyWhoHasJustCome) {
  StartSchedule starts;
  starts.startBegins(1000 * kMs, false);
  starts.noteHull(1000 * kMs, false);
  starts.startBegins(3000 * kMs, false);
  EXPECT_TRUE(starts.rests(3399 * kMs));
  starts.noteHull(3000 * kMs, true);
  starts.startBegins(3400 * kMs, false);
  EXPECT_TRUE(starts.rests(3479 * kMs));
  EXPECT_FALSE(starts.rests(3480 * kMs));
}

TEST(StartScheduleTest, ChecksSoonWhatACheckByColourHasPutInPlace) {
  StartSchedule starts;
  starts.startBegins(0, true);
  for (int i = 0; i < 3; ++i) starts.colorCheckBegins(1000 * kMs);
  EXPECT_FALSE(starts.isCheckDue(1799 * kMs));
  starts.confirm();
  starts.contradict(1000 * kMs);
  EXPECT_FALSE(starts.isConfirmed());
  EXPECT_FALSE(starts.isCheckDue(1199 * kMs));
  EXPECT_TRUE(starts.isCheckDue(1200 * kMs));
}

TEST(StartScheduleTest, ChecksByColourUntilTwoConfirmInARow) {
  StartSchedule starts;
  starts.startBegins(0, true);
  EXPECT_FALSE(starts.isCheckDue(49 * kMs));
  EXPECT_TRUE(starts.isCheckDue(50 * kMs));
  int64_t now = 50 * kMs;
  for (int64_t pause : {200, 400}) {
    starts.colorCheckBegins(now);
    EXPECT_FALSE(starts.isCheckDue(now + pause * kMs - 1));
    EXPECT_TRUE(starts.isCheckDue(now += pause * kMs));
    EXPECT_TRUE(starts.wantsColorChecks());
    starts.confirm();
  }
  EXPECT_FALSE(starts.wantsColorChecks());
}

}  // namespace
}  // namespace markerless_mocap
