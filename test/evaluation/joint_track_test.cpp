#include "evaluation/joint_track.h"

#include <gtest/gtest.h>

#include "evaluation/walking_track.h"

namespace markerless_mocap {
namespace {

TEST(MatchStamps, TakesTheNearestWithinTheTolerance) {
  EXPECT_EQ(matchStamps({0, 100, 200, 300}, {2, 110, 155, 290}, 45),
            (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(matchStamps({0, 100, 200}, {50}, 45), (std::vector<int>{-1, -1, -1}));
}

TEST(MatchStamps, OneFrameTakesTheNearestOfSeveral) {
  EXPECT_EQ(matchStamps({0, 100}, {70, 95, 120}, 45), (std::vector<int>{-1, 1}));
}

TEST(MatchStamps, NothingMatchesNothing) {
  EXPECT_EQ(matchStamps({}, {1, 2}, 10), std::vector<int>());
  EXPECT_EQ(matchStamps({1, 2}, {}, 10), (std::vector<int>{-1, -1}));
}

TEST(FrameTime, IsNotChangedByAGap) {
  EXPECT_EQ(frameTime({0, 10, 20, 500, 510}), 10);
  EXPECT_EQ(frameTime({7}), 0);
}

TEST(JointTrack, AlignedToAcceptsClocksThatDifferByLessThanHalfAFrame) {
  const JointTrack truth = walkingTrack(5);
  JointTrack estimate = truth;
  for (int64_t& stamp : estimate.stamps_ns) stamp += kFrame * 4 / 10;
  const JointTrack aligned = alignedTo(truth, estimate);
  EXPECT_EQ(aligned.stamps_ns, truth.stamps_ns);
  for (int f = 0; f < 5; ++f) EXPECT_EQ(aligned.positions[f], truth.positions[f]) << f;
  for (int64_t& stamp : estimate.stamps_ns) stamp += kFrame / 10;  // now half a frame
  EXPECT_TRUE(alignedTo(truth, estimate).positions[2].array().isNaN().all());
}

TEST(JointTrack, NamesAreSortedAndWhatIsNotThereIsMissing) {
  JointTrack track;
  track.names = {"b", "a"};
  track.add(1, (Eigen::Matrix3Xd(3, 2) << 1, 2, 1, 2, 1, 2).finished());
  const JointTrack chosen = track.select({"a", "c"});
  EXPECT_EQ(chosen.positions[0].col(0), Eigen::Vector3d(2, 2, 2));
  EXPECT_TRUE(chosen.positions[0].col(1).array().isNaN().all());
}

TEST(JointTrack, RefusesFramesThatDoNotFollow) {
  JointTrack track = walkingTrack(2);
  EXPECT_THROW(track.add(track.stamps_ns.back(), track.positions[0]), std::invalid_argument);
  EXPECT_THROW(track.add(track.stamps_ns.back() + 1, Eigen::Matrix3Xd::Zero(3, 2)),
               std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
