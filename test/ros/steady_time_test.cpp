#include "nodes/pose_fitting/steady_time.h"

#include <gtest/gtest.h>

#include "nodes/common/catch_up_queue.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kMs = 1'000'000;
constexpr int64_t kPeriod = 67 * kMs;

/// Frame sets at 15 per second; `clock_ns` is what the cameras' clock says more than ours.
struct FrameSets {
  SteadyTime time;
  int64_t now_ns = 5000 * kMs, clock_ns = 1'000'000'000 * kMs, last_ns = 0;
  SteadyTime::Moment last;

  /// How far the tracker's time has gone on, ns.
  int64_t send(int64_t passed_ns = kPeriod) {
    now_ns += passed_ns;
    last = time.at(now_ns + clock_ns, now_ns);
    const int64_t gone_on_ns = last.time_ns - last_ns;
    last_ns = last.time_ns;
    return gone_on_ns;
  }
  void sendGood(int frame_sets) {
    for (int i = 0; i < frame_sets; ++i) {
      EXPECT_EQ(send(), kPeriod);
      EXPECT_EQ(last.set_by_ns, 0);
      EXPECT_FALSE(last.after_pause);
    }
  }
};

TEST(SteadyTime, BeginsWithTheFirstStamp) {
  FrameSets sets;
  sets.send();
  EXPECT_EQ(sets.last.time_ns, sets.now_ns + sets.clock_ns);
  EXPECT_EQ(sets.last.set_by_ns, 0);
  sets.sendGood(3);
}

TEST(SteadyTime, GoesOnWhenTheClockIsSetAndSetRight) {
  for (const int64_t step : {1'000'000 * kMs, -100'000 * kMs, -3'600'000 * kMs, 5000 * kMs}) {
    FrameSets sets;
    sets.send();
    sets.sendGood(20);
    for (const int64_t set_by : {step, -step}) {
      sets.clock_ns += set_by;
      const int64_t gone_on = sets.send(3 * kPeriod);  // some images are doubted at first
      EXPECT_GE(gone_on, 3 * kPeriod - kMs) << set_by;
      EXPECT_LT(gone_on, 500 * kMs) << set_by;
      EXPECT_NEAR(double(sets.last.set_by_ns), double(set_by), 1e6) << set_by;
      EXPECT_FALSE(sets.last.after_pause);
      EXPECT_EQ(sets.time.timeOf(sets.now_ns + sets.clock_ns), sets.last.time_ns);
      sets.sendGood(5);
    }
  }
}

TEST(SteadyTime, ASmallStepBackCostsNothing) {
  FrameSets sets;
  sets.send();
  sets.sendGood(20);
  sets.clock_ns -= 1000 * kMs;
  EXPECT_EQ(sets.send(), kPeriod);
  EXPECT_EQ(sets.last.set_by_ns, -1000 * kMs);
  sets.sendGood(5);
}

TEST(SteadyTime, APauseIsNoStepOfTheClock) {
  FrameSets sets;
  sets.send();
  sets.sendGood(20);
  EXPECT_EQ(sets.send(3000 * kMs), 3000 * kMs);
  EXPECT_EQ(sets.last.set_by_ns, 0);
  EXPECT_TRUE(sets.last.after_pause);
  sets.sendGood(5);
}

TEST(SteadyTime, FrameSetsThatCameLateCatchUpWithoutAStepOfTheClock) {
  FrameSets sets;
  sets.send();
  sets.sendGood(20);
  // The process stood still for 8 s: frame sets of then come at once, those between are lost.
  const int64_t stopped_ns = sets.now_ns;
  for (int i = 1; i <= 5; ++i)
    sets.last = sets.time.at(stopped_ns + i * kPeriod + sets.clock_ns, stopped_ns + 8000 * kMs + i);
  sets.last_ns = sets.last.time_ns;
  sets.now_ns = stopped_ns + 8000 * kMs;
  const int64_t gone_on = sets.send(100 * kMs);
  EXPECT_GE(gone_on, 200 * kMs) << "a gap that makes a tracker doubt";
  EXPECT_LE(gone_on, 450 * kMs);
  EXPECT_EQ(sets.last.set_by_ns, 0);
  sets.sendGood(5);
}

TEST(SteadyTime, AfterAClockThatStoodStillATrackerDoubts) {
  FrameSets sets;
  sets.send();
  sets.sendGood(20);
  sets.clock_ns -= 5000 * kMs;
  EXPECT_EQ(sets.send(5000 * kMs + kPeriod), 450 * kMs);
  EXPECT_EQ(sets.last.set_by_ns, 0);
  sets.sendGood(5);
}

TEST(SteadyTime, ABagThatIsPlayedSlowlyIsNoClockThatStandsStill) {
  FrameSets sets;
  sets.send();
  for (int i = 0; i < 20; ++i) {
    sets.clock_ns -= 1500 * kMs;
    const int64_t gone_on = sets.send(1500 * kMs + kPeriod);
    if (i > 3) {
      EXPECT_EQ(gone_on, kPeriod) << i;
    }
  }
}

TEST(SteadyTime, AFastBagWithAGapIsNoStepOfTheClock) {
  FrameSets sets;
  sets.send();
  sets.sendGood(20);
  sets.clock_ns += 1500 * kMs;
  EXPECT_EQ(sets.send(500 * kMs), 2000 * kMs);
  EXPECT_TRUE(sets.last.after_pause);
}

TEST(SteadyTime, AfterAPauseAClockThatWasSetBackBeginsAnew) {
  FrameSets sets;
  sets.send();
  sets.sendGood(20);
  sets.clock_ns -= 100'000 * kMs;
  sets.send(3000 * kMs);
  EXPECT_EQ(sets.last.time_ns, sets.now_ns + sets.clock_ns);
  EXPECT_TRUE(sets.last.after_pause);
}

/// While frame sets wait, those around a step of the clock lead over it.
TEST(SteadyTime, FrameSetsThatWaitAreKeptAroundAStepBack) {
  CatchUpQueue<int64_t> queue(90);
  for (int i = 0; i < 20; ++i)
    queue.push(i * kPeriod + (i < 10 ? 1'000'000 * kMs : 0));  // set right after ten
  queue.thinOut(3, [](int64_t one, int64_t other) { return isWithin(150 * kMs, one, other); });
  int64_t before = *queue.take();
  for (bool stepped = false; queue.waitingCount() > 0;) {
    const int64_t next = *queue.take();
    if (next > before) {
      EXPECT_LT(next - before, 150 * kMs);
    } else {
      EXPECT_FALSE(stepped);
      stepped = true;
      EXPECT_EQ(before, 9 * kPeriod + 1'000'000 * kMs);
      EXPECT_EQ(next, 10 * kPeriod);
    }
    before = next;
  }
  EXPECT_EQ(before, 19 * kPeriod);
}

}  // namespace
}  // namespace markerless_mocap
