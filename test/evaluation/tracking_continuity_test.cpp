#include "evaluation/tracking_continuity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace markerless_mocap {
namespace {

/// One letter a frame: t(racked) r(einitialized) l(ost) m(issing); 10 frames per second.
TrackingContinuity recordOf(const std::string& letters) {
  std::vector<int64_t> stamps;
  std::vector<FrameStatus> statuses;
  for (const char c : letters) {
    stamps.push_back(int64_t(stamps.size()) * 100000000);
    statuses.push_back(c == 't'   ? FrameStatus::kTracked
                       : c == 'r' ? FrameStatus::kReinitialized
                       : c == 'l' ? FrameStatus::kLost
                                  : FrameStatus::kMissing);
  }
  return trackingContinuity(stamps, statuses);
}

TEST(TrackingContinuity, CountsEachStatus) {
  const TrackingContinuity record = recordOf("mlrttltr");
  EXPECT_EQ(record.missing, 1u);
  EXPECT_EQ(record.lost, 2u);
  EXPECT_EQ(record.tracked, 3u);
  EXPECT_EQ(record.reinitialized, 2u);
}

TEST(TrackingContinuity, LossesRunUntilTheNextPoseAndBeginAfterTheFirst) {
  const TrackingContinuity record = recordOf("mlrtllmrtltl");
  EXPECT_NEAR(record.seconds_to_first_pose, 0.2, 1e-12);
  ASSERT_EQ(record.losses.size(), 3u);
  EXPECT_EQ(record.losses[0].first, 4u);
  EXPECT_EQ(record.losses[0].frames, 3u);
  EXPECT_NEAR(record.losses[0].seconds, 0.3, 1e-12);
  EXPECT_EQ(record.losses[1].frames, 1u);
  EXPECT_NEAR(record.longest_loss(), 0.3, 1e-12);
  EXPECT_EQ(record.frames_after_start, 10u);
  EXPECT_NEAR(record.fraction_without_pose_after_start, 0.5, 1e-12);
}

TEST(TrackingContinuity, WithoutAPoseThereIsNoLoss) {
  const TrackingContinuity record = recordOf("mmll");
  EXPECT_TRUE(std::isnan(record.seconds_to_first_pose));
  EXPECT_TRUE(record.losses.empty());
  EXPECT_TRUE(std::isnan(record.fraction_without_pose_after_start));
  EXPECT_EQ(record.longest_loss(), 0.0);
}

TEST(TrackingContinuity, TakesOneStatusForEachStamp) {
  EXPECT_THROW(trackingContinuity({0, 1}, {FrameStatus::kLost}), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
