#include "nodes/silhouette/first_masks.h"

#include <gtest/gtest.h>

#include <string>

namespace markerless_mocap {
namespace {

constexpr int64_t kPeriod = 100'000'000, kSkew = 3'000'000;  // ns

/// Three cameras at ten images a second; a letter is what one does: collects, learns, is ready.
class FirstMasksTest : public testing::Test {
 protected:
  /// Which cameras publish the mask of this frame set.
  std::string publish(const std::string& phases) {
    std::string published;
    for (size_t i = 0; i < phases.size(); ++i) {
      const CameraPhase phase = phases[i] == 'c'   ? CameraPhase::kCollecting
                                : phases[i] == 'l' ? CameraPhase::kLearning
                                                   : CameraPhase::kReady;
      if (phases[i] == '-') continue;
      const int64_t stamp_ns = time_ * kPeriod + int64_t(i) * kSkew;
      if (masks_.mayPublish(i, stamp_ns, phase, 1e-9 * double(stamp_ns)))
        published += std::to_string(i);
    }
    ++time_;
    return published;
  }
  int64_t time_ = 0;
  FirstMasks masks_{3};
};

TEST_F(FirstMasksTest, CamerasThatLearnBeginWithTheSameFrameSet) {
  EXPECT_EQ(publish("ccc"), "");
  EXPECT_EQ(publish("lll"), "");
  EXPECT_EQ(publish("rll"), "");
  EXPECT_EQ(publish("rrl"), "");
  EXPECT_EQ(publish("rrr"), "");  // the first two were asked before the third was ready
  EXPECT_EQ(publish("rrr"), "012");
}

TEST_F(FirstMasksTest, WithAKeptBackgroundTheyBeginAtOnce) {
  EXPECT_EQ(publish("rrr"), "012");
}

TEST_F(FirstMasksTest, NobodyWaitsForOneThatCollects) {
  EXPECT_EQ(publish("rcr"), "02");
}

TEST_F(FirstMasksTest, WhoHasBegunGoesOnWhileAnotherLearnsAnew) {
  EXPECT_EQ(publish("rrr"), "012");
  EXPECT_EQ(publish("rcr"), "02");
  EXPECT_EQ(publish("rlr"), "02");
  EXPECT_EQ(publish("rrr"), "02");
  EXPECT_EQ(publish("rrr"), "012");
}

TEST_F(FirstMasksTest, NobodyWaitsForOneThatHasStopped) {
  EXPECT_EQ(publish("lll"), "");
  for (int i = 0; i < 6; ++i) EXPECT_EQ(publish("rr-"), "") << i;
  EXPECT_EQ(publish("rr-"), "01");
}

TEST_F(FirstMasksTest, ABagThatBeginsAgainWaitsForNoTimeThatIsOver) {
  time_ = 100;
  EXPECT_EQ(publish("lll"), "");
  EXPECT_EQ(publish("rrr"), "");
  time_ = 0;
  EXPECT_EQ(publish("rrr"), "012");
}

}  // namespace
}  // namespace markerless_mocap
