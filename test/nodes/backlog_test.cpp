#include "nodes/pose_fitting/backlog.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

TEST(Backlog, AsSoonAsSomethingWaitsNothingIsSearched) {
  Backlog backlog(3);
  backlog.begin(0, 100.0);
  EXPECT_FALSE(backlog.isBehind(0));
  EXPECT_TRUE(backlog.isBehind(1)) << "it has come meanwhile";
  EXPECT_FALSE(backlog.isBehind(0));
}

TEST(Backlog, AfterASearchItCatchesUpFirst) {
  Backlog backlog(3);
  backlog.begin(0, 100.0);
  for (const int waiting : {3, 2, 1}) {
    backlog.begin(size_t(waiting), 100.4);
    EXPECT_TRUE(backlog.isBehind(size_t(waiting))) << waiting;
  }
  backlog.begin(0, 100.4);
  EXPECT_FALSE(backlog.isBehind(0));
}

TEST(Backlog, WhoNeverCatchesUpSearchesNowAndThen) {
  Backlog backlog(3);
  backlog.begin(0, 100.0);
  int searches = 0;
  for (int item = 1; item <= 100; ++item) {
    backlog.begin(2, 100.0 + 0.1 * item);
    searches += !backlog.isBehind(2);
  }
  EXPECT_GE(searches, 4) << "in ten seconds";
  EXPECT_LE(searches, 5);
}

TEST(Backlog, TheTimeOfASearchIsNotTimeToCatchUp) {
  Backlog backlog(3);
  backlog.begin(0, 100.0);
  for (int item = 1; item <= 10; ++item) {
    backlog.begin(2, 103.0 + 0.1 * item);  // the first one was searched for three seconds
    EXPECT_TRUE(backlog.isBehind(2)) << item;
  }
}

TEST(Backlog, WhoIsFarBehindNeverSearches) {
  Backlog backlog(3);
  backlog.begin(0, 100.0);
  for (int item = 1; item <= 100; ++item) {
    backlog.begin(4, 100.0 + 0.1 * item);
    EXPECT_TRUE(backlog.isBehind(4)) << item;
  }
}

}  // namespace
}  // namespace markerless_mocap
