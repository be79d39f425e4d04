#include "nodes/silhouette/load_shedding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace markerless_mocap {
namespace {

constexpr int64_t kSkew = 3'000'000;  // ns

/// Three cameras at 20 images a second.
class LoadSheddingTest : public testing::Test {
 protected:
  /// Which cameras' images of the next frame set are processed, if they wait for so long.
  std::string admit(double waited_s) {
    std::string admitted;
    for (size_t i = 0; i < 3; ++i) {
      const int64_t stamp_ns = set_ * kPeriod + int64_t(i) * kSkew;
      if (load_.admits(i, stamp_ns, waited_s, 1e-9 * double(stamp_ns) + waited_s))
        admitted += std::to_string(i);
    }
    ++set_;
    return admitted;
  }
  static constexpr int64_t kPeriod = 50'000'000;  // ns
  int64_t set_ = 0;
  LoadShedding load_{3};
};

TEST_F(LoadSheddingTest, WhileNothingWaitsAllIsProcessed) {
  for (int i = 0; i < 100; ++i) EXPECT_EQ(admit(0.001), "012") << i;
}

TEST_F(LoadSheddingTest, AShortPeakIsWaitedOut) {
  admit(0.001);
  for (const double waited_s : {0.14, 0.11, 0.08}) EXPECT_EQ(admit(waited_s), "012") << waited_s;
  EXPECT_EQ(admit(0.001), "012");
  EXPECT_EQ(admit(0.14), "012") << "a peak of its own";
}

TEST_F(LoadSheddingTest, AfterALongWaitOnlyWhatHasWaitedLittleIsLetIn) {
  admit(0.001);
  EXPECT_EQ(admit(0.16), "");
  EXPECT_EQ(admit(0.10), "");
  EXPECT_EQ(admit(0.04), "012");
  EXPECT_EQ(admit(0.06), "") << "the overload goes on";
}

TEST_F(LoadSheddingTest, WithoutFurtherLongWaitsTheOverloadIsOver) {
  EXPECT_EQ(admit(0.16), "");
  for (int i = 0; i < 15; ++i) EXPECT_EQ(admit(0.001), "012") << i;
  EXPECT_EQ(admit(0.06), "012");
}

TEST_F(LoadSheddingTest, AfterABagBeginsAgainItDecidesAnew) {
  set_ = 100;
  EXPECT_EQ(admit(0.16), "");
  set_ = 0;
  EXPECT_EQ(admit(0.001), "012");
}

// Whatever the order in which the cameras' threads come, one frame set is one decision.
TEST(LoadShedding, CamerasOfAFrameSetAreDecidedOnTogether) {
  constexpr size_t kCameras = 5;
  constexpr int64_t kPeriod = 33'000'000;
  constexpr int kSets = 400, kAhead = 6;  // by so many frame sets a camera may be ahead of another
  std::mt19937 random(1);
  LoadShedding load(kCameras);
  std::vector<int> next(kCameras, 0);
  std::vector<std::vector<bool>> admitted(kSets);
  int slowest = 0;
  while (slowest < kSets) {
    const size_t camera = random() % kCameras;
    const int set = next[camera];
    if (set == kSets || set > slowest + kAhead) continue;
    const int64_t stamp_ns = set * kPeriod + int64_t(random() % 5'000'000);
    const double waited_s = 0.001 * double(random() % 200);
    admitted[size_t(set)].push_back(
        load.admits(camera, stamp_ns, waited_s, 1e-9 * double(stamp_ns) + waited_s));
    ++next[camera];
    slowest = *std::min_element(next.begin(), next.end());
  }
  int left_out = 0;
  for (int set = 0; set < kSets; ++set) {
    const std::vector<bool>& of_set = admitted[size_t(set)];
    ASSERT_EQ(of_set.size(), kCameras);
    for (const bool one : of_set) EXPECT_EQ(one, of_set[0]) << set;
    left_out += !of_set[0];
  }
  EXPECT_GT(left_out, 20);
  EXPECT_LT(left_out, kSets - 20);
}

}  // namespace
}  // namespace markerless_mocap
