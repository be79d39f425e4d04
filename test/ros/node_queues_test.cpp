#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include <memory>
#include <thread>
#include <vector>

#include "nodes/common/catch_up_queue.h"
#include "nodes/common/holding_queue.h"
#include "nodes/common/latency_meter.h"
#include "nodes/common/stamp_cache.h"
#include "nodes/pose_fitting/answers.h"
#include "nodes/pose_fitting/color_demand.h"
#include "nodes/pose_fitting/recent_messages.h"

namespace markerless_mocap {
namespace {

using Item = std::shared_ptr<int>;

Item item(int value) {
  return std::make_shared<int>(value);
}

TEST(StampCache, NearestStampWithinTheToleranceIsTaken) {
  StampCache<Item> store(2, 8);
  for (const int stamp : {100, 104, 110}) store.add(1, stamp, item(stamp));
  EXPECT_EQ(store.take(0, 104, 5), nullptr);
  EXPECT_EQ(store.take(1, 120, 5), nullptr);
  const Item found = store.take(1, 106, 5);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, 104);
}

TEST(StampCache, WhatCameBeforeGoesToo) {
  StampCache<Item> store(1, 8);
  for (const int stamp : {100, 110, 120}) store.add(0, stamp, item(stamp));
  EXPECT_TRUE(store.take(0, 110, 0));
  EXPECT_EQ(store.take(0, 100, 0), nullptr);
  EXPECT_EQ(store.take(0, 110, 0), nullptr);
  EXPECT_TRUE(store.take(0, 120, 0));
}

TEST(StampCache, EarlierStampsAfterLaterOnesAreKept) {
  StampCache<Item> store(1, 8);  // a bag that begins again
  for (const int stamp : {500, 510, 100, 110}) store.add(0, stamp, item(stamp));
  EXPECT_TRUE(store.take(0, 510, 0));
  EXPECT_TRUE(store.take(0, 100, 0));
}

TEST(StampCache, HoldsNoMoreThanItMay) {
  StampCache<Item> store(1, 3);
  const Item first = item(0);
  store.add(0, 0, first);
  for (int stamp = 1; stamp < 4; ++stamp) store.add(0, stamp, item(stamp));
  EXPECT_EQ(first.use_count(), 1);
  EXPECT_TRUE(store.take(0, 1, 0));
}

TEST(StampCache, WhatIsALittleBehindMayStillCome) {
  StampCache<Item> store(2, 8);
  EXPECT_FALSE(store.mayStillCome(0, 100, 5, 50));  // nothing has ever come
  store.add(0, 100, item(0));
  EXPECT_FALSE(store.mayStillCome(0, 105, 5, 50));  // it is there
  EXPECT_TRUE(store.take(0, 105, 5));
  EXPECT_FALSE(store.mayStillCome(0, 105, 5, 50));
  EXPECT_TRUE(store.mayStillCome(0, 106, 5, 50));
  EXPECT_TRUE(store.mayStillCome(0, 150, 5, 50));
  EXPECT_FALSE(store.mayStillCome(0, 151, 5, 50));  // the camera has stopped
  EXPECT_FALSE(store.mayStillCome(0, 90, 5, 50));   // it was left out
  EXPECT_FALSE(store.mayStillCome(1, 106, 5, 50));
}

TEST(StampCache, WithoutALimitTheNextMayAlwaysStillCome) {
  StampCache<Item> store(1, 8);
  EXPECT_FALSE(store.mayStillCome(0, 100));
  store.add(0, 100, item(0));
  EXPECT_FALSE(store.mayStillCome(0, 100));
  EXPECT_TRUE(store.mayStillCome(0, 101));
  EXPECT_TRUE(store.mayStillCome(0, 2'000'000'000'000'000'000));
}

TEST(HoldingQueue, OneThatWaitsHoldsThoseBehindItUntilTooManyWait) {
  HoldingQueue<Item> queue(2);
  std::vector<int> out;
  const auto release = [&](int waiting) {
    queue.release([&](const Item& i) { return *i == waiting; },
                  [&](const Item& i) { out.push_back(*i); });
  };
  for (const int i : {1, 2}) queue.push(item(i));
  release(1);
  EXPECT_EQ(out, std::vector<int>());
  release(2);
  EXPECT_EQ(out, std::vector<int>({1}));
  for (const int i : {3, 4}) queue.push(item(i));
  release(2);
  EXPECT_EQ(out, std::vector<int>({1, 2, 3, 4}));
  queue.push(item(5));
  queue.clear();
  release(0);
  EXPECT_EQ(out.size(), 4u);
}

TEST(ColorDemand, ImagesAreNeededWhileMasksNeedColorsAndAShortTimeLonger) {
  ColorDemand demand(2, 50);
  EXPECT_FALSE(demand.isNeeded(0, 0));
  demand.note(0, 100);
  EXPECT_TRUE(demand.isNeeded(0, 100));
  EXPECT_TRUE(demand.isNeeded(0, 150));
  EXPECT_FALSE(demand.isNeeded(0, 151));
  EXPECT_FALSE(demand.isNeeded(0, 40));  // a bag that begins again
  EXPECT_FALSE(demand.isNeeded(1, 100));
}

TEST(ColorDemand, OfAGreyCameraNothingIsNeeded) {
  ColorDemand demand(2, 50);
  for (const size_t camera : {0, 1}) demand.note(camera, 100);
  demand.noteGrey(0);
  demand.note(0, 110);
  EXPECT_FALSE(demand.isNeeded(0, 110));
  EXPECT_TRUE(demand.isNeeded(1, 110));
}

TEST(CatchUpQueue, TellsHowManyWait) {
  CatchUpQueue<int> queue(3);
  EXPECT_EQ(queue.waitingCount(), 0u);
  for (int i = 0; i < 3; ++i) queue.push(i);
  EXPECT_EQ(queue.waitingCount(), 3u);
  queue.take();
  EXPECT_EQ(queue.waitingCount(), 2u);
}

TEST(CatchUpQueue, ItemsBehindASlowOneWait) {
  CatchUpQueue<int> queue(3);
  for (int i = 0; i < 3; ++i) queue.push(i);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(queue.take(), i);
  EXPECT_EQ(queue.droppedCount(), 0u);
}

TEST(CatchUpQueue, WhoFallsBehindGetsTheNewestUntilNoneIsLeft) {
  CatchUpQueue<int> queue(3);
  for (int i = 0; i < 6; ++i) queue.push(i);
  EXPECT_EQ(queue.take(), 5);
  EXPECT_EQ(queue.droppedCount(), 5u);
  queue.push(6);  // still behind: brought while 5 is worked on
  queue.push(7);
  EXPECT_EQ(queue.take(), 7);
  EXPECT_EQ(queue.droppedCount(), 6u);
}

TEST(CatchUpQueue, ThinnedOutItLeadsToTheNewestWithoutALargeGap) {
  CatchUpQueue<int> queue(100);
  const auto near = [](int one, int other) { return other - one <= 8; };
  for (int i = 0; i < 60; ++i) {
    queue.push(i);
    queue.thinOut(3, near);
  }
  std::vector<int> left;
  while (queue.waitingCount() > 0) left.push_back(*queue.take());
  EXPECT_EQ(left.front(), 0);
  EXPECT_EQ(std::vector<int>(left.end() - 3, left.end()), (std::vector<int>{57, 58, 59}));
  for (size_t i = 1; i < left.size(); ++i) EXPECT_LE(left[i] - left[i - 1], 8);
  EXPECT_LE(left.size(), 60 / 8 + 4u);
  EXPECT_EQ(queue.droppedCount(), 60 - left.size());
}

TEST(CatchUpQueue, WhoHasHadToWaitHasCaughtUp) {
  CatchUpQueue<int> queue(3);
  for (int i = 0; i < 6; ++i) queue.push(i);
  EXPECT_EQ(queue.take(), 5);
  int oldest = 0;
  for (int i = 0; i < 1000 && oldest != 7; ++i) {  // until take() comes before push()
    std::thread later([&] { queue.push(6); });
    EXPECT_EQ(queue.take(), 6);
    later.join();
    queue.push(7);
    queue.push(8);
    oldest = *queue.take();
    EXPECT_TRUE(oldest == 8 || queue.take() == 8);
  }
  EXPECT_EQ(oldest, 7);
}

TEST(CatchUpQueue, ClosedItGivesNothing) {
  CatchUpQueue<int> queue(3);
  std::thread closer([&] { queue.close(); });
  EXPECT_EQ(queue.take(), std::nullopt);
  closer.join();
  queue.push(1);
  EXPECT_EQ(queue.take(), std::nullopt);
}

TEST(LatencyMeter, MedianAndTailOfTheLastTenSeconds) {
  LatencyMeter meter;
  EXPECT_EQ(meter.milliseconds(0.5), 0u);
  for (int i = 0; i < 300; ++i) meter.add(0.01 * i, 9.0);
  for (int i = 1; i <= 300; ++i) meter.add(10.02 + 0.01 * i, 1e-3 * i);
  EXPECT_NEAR(double(meter.milliseconds(0.5)), 150.0, 1.0);
  EXPECT_NEAR(double(meter.milliseconds(0.99)), 297.0, 1.0);
}

std_msgs::Header headerAt(double seconds) {
  std_msgs::Header header;
  header.stamp = ros::Time(seconds);
  return header;
}

TEST(Answers, EachFrameSetIsAnsweredOnce) {
  Answers answers;
  for (const double stamp : {1.0, 2.0, 3.0, 4.0}) answers.await(headerAt(stamp));
  const auto late = answers.takeLate(2);
  ASSERT_TRUE(late);
  EXPECT_EQ(late->stamp, ros::Time(1.0));
  EXPECT_EQ(answers.takeLate(2)->stamp, ros::Time(2.0));
  EXPECT_FALSE(answers.takeLate(2)) << "two may wait";
  EXPECT_FALSE(answers.take(headerAt(2.0))) << "it came too late";
  EXPECT_TRUE(answers.take(headerAt(4.0)));
  EXPECT_FALSE(answers.take(headerAt(3.0))) << "earlier ones were dropped";
}

TEST(RecentMessages, AreFoundByStampOrAsTheNewest) {
  RecentMessages<int> recent;
  recent.expect(0.0);
  for (const int stamp : {100, 110, 120}) recent.add(stamp, boost::make_shared<int>(stamp), 1.0);
  EXPECT_EQ(*recent.at(111, 5), 110);
  EXPECT_FALSE(recent.at(130, 5));
  EXPECT_EQ(*recent.newest(150, 40), 120);
  EXPECT_FALSE(recent.newest(150, 20));
}

TEST(RecentMessages, AreAwaitedUntilALaterOneHasComeOrTheStageIsSilent) {
  RecentMessages<int> recent;
  recent.expect(10.0);
  EXPECT_TRUE(recent.mayCome(100, 10.9)) << "a stage that was at rest has to be connected";
  EXPECT_FALSE(recent.mayCome(100, 11.1));
  for (int i = 0; i < 20; ++i) recent.add(i, boost::make_shared<int>(i), 12.0 + 0.2 * i);
  const double last = 12.0 + 0.2 * 19;
  EXPECT_FALSE(recent.mayCome(18, last)) << "a later one has come";
  EXPECT_TRUE(recent.mayCome(20, last + 0.5)) << "slow stages are given three times as long";
  EXPECT_FALSE(recent.mayCome(20, last + 0.7));
}

TEST(RecentMessages, OfALoopThatBeganAgainAreNotThoseOfTheLast) {
  RecentMessages<int> recent;
  recent.add(500, boost::make_shared<int>(500), 1.0);
  recent.add(100, boost::make_shared<int>(100), 1.1);
  EXPECT_FALSE(recent.at(500, 5));
  EXPECT_TRUE(recent.mayCome(110, 1.2));
}

}  // namespace
}  // namespace markerless_mocap
