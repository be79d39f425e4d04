#include "evaluation/foot_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame = 40000000;  // 25 frames per second, ns
constexpr int kFrames = 25;

/// The left ball rests in frames 0 to 9, takes a step of a metre and rests again from 15 on; the
/// right foot stays in the air. As speed is taken over the frames before and after, contact ends
/// with frame 8 and begins again with 16.
JointTrack step(const std::function<void(int frame, Eigen::Matrix3Xd* points)>& change) {
  JointTrack track;
  track.names = {"l_foot", "r_foot"};
  for (int f = 0; f < kFrames; ++f) {
    Eigen::Matrix3Xd points(3, 2);
    const bool flies = f > 9 && f < 15;
    points.col(0) << std::min(std::max(0.0, (f - 9) / 6.0), 1.0), 0.0, flies ? 0.13 : 0.03;
    points.col(1) << 0.0, -0.3, 0.5;
    change(f, &points);
    track.add(f * kFrame, points);
  }
  return track;
}
void nothing(int, Eigen::Matrix3Xd*) {}

TEST(FootContact, IsWhereAPointIsLowAndSlow) {
  const FootContact found = footContact(step(nothing), step(nothing), "l_foot");
  ASSERT_EQ(found.contacts.size(), 2u);
  EXPECT_EQ(found.contacts[0].run.first, 0u);
  EXPECT_EQ(found.contacts[0].run.frames, 9u);
  EXPECT_NEAR(found.contacts[0].run.seconds, 0.32, 1e-12);
  EXPECT_EQ(found.contacts[1].run.first, 16u);
  EXPECT_EQ(found.contacts[1].run.frames, 9u);
  EXPECT_EQ(found.precision, 1.0);
  EXPECT_EQ(found.recall, 1.0);
  EXPECT_EQ(found.max_slide_mm.max, 0.0);
}

TEST(FootContact, AFootInTheAirHasNone) {
  const FootContact found = footContact(step(nothing), step(nothing), "r_foot");
  EXPECT_TRUE(found.contacts.empty());
  EXPECT_TRUE(std::isnan(found.recall));
  EXPECT_TRUE(std::isnan(found.max_slide_mm.mean));
}

TEST(FootContact, SlideIsHowFarTheEstimateGoesWhileTheTruthRests) {
  // 1 mm a frame forward in the first contact, which is 25 mm/s; there and back in the second.
  const JointTrack estimate = step([](int f, Eigen::Matrix3Xd* points) {
    (*points)(2, 0) += 0.02;  // the ball sits elsewhere in this body's foot
    if (f <= 8) (*points)(0, 0) += 1e-3 * f;
    if (f >= 20 && f < 22) (*points)(1, 0) += 3e-3;
  });
  const FootContact found = footContact(step(nothing), estimate, "l_foot");
  ASSERT_EQ(found.contacts.size(), 2u);
  EXPECT_NEAR(found.contacts[0].max_slide_mm, 8.0, 1e-9);
  EXPECT_NEAR(found.contacts[0].path_mm_per_s, 25.0, 1e-9);
  EXPECT_NEAR(found.contacts[1].max_slide_mm, 3.0, 1e-9);
  EXPECT_NEAR(found.contacts[1].path_mm_per_s, 6.0 / 0.32, 1e-9);
  EXPECT_EQ(found.contacts[1].true_path_mm_per_s, 0.0);
  EXPECT_NEAR(found.max_slide_mm.mean, 5.5, 1e-9);
  EXPECT_EQ(found.recall, 1.0);
}

TEST(FootContact, FramesWithoutEstimateDoNotCount) {
  const JointTrack estimate = step([](int f, Eigen::Matrix3Xd* points) {
    if (f < 16) points->setConstant(NAN);
    if (f == 18) points->setConstant(NAN);
  });
  const FootContact found = footContact(step(nothing), estimate, "l_foot");
  EXPECT_TRUE(std::isnan(found.contacts[0].max_slide_mm));
  EXPECT_EQ(found.contacts[1].max_slide_mm, 0.0);
  EXPECT_EQ(found.max_slide_mm.count, 1u);
  EXPECT_EQ(found.recall, 6.0 / 8);  // 16 and 17 are too short to be a contact by themselves
  EXPECT_EQ(found.precision, 1.0);
}

TEST(FootContact, AnEstimateThatDragsItsFootIsSeenToRestWhereItDoesNot) {
  const JointTrack estimate = step([](int f, Eigen::Matrix3Xd* points) {
    points->col(0) << 0.1 * f * 0.04, 0.0, 0.03;  // 0.1 m/s all along
  });
  const FootContact found = footContact(step(nothing), estimate, "l_foot");
  EXPECT_EQ(found.precision, 18.0 / 25);
  EXPECT_EQ(found.recall, 1.0);
}

TEST(FootContact, TakesTracksOfTheSameFrames) {
  JointTrack shorter = step(nothing);
  shorter.stamps_ns.pop_back();
  shorter.positions.pop_back();
  EXPECT_THROW(footContact(step(nothing), shorter, "l_foot"), std::invalid_argument);
}

TEST(SoleStatistics, CountDepthsBelowTheFloor) {
  const SoleStatistics sole =
      soleStatistics({0.010, -0.005, -0.020, NAN}, {true, true, false, true});
  EXPECT_EQ(sole.frames, 3u);
  EXPECT_NEAR(sole.fraction_below, 1.0 / 3, 1e-12);
  EXPECT_NEAR(sole.mean_below_mm, 25.0 / 3, 1e-9);
  EXPECT_NEAR(sole.deepest_mm, 20.0, 1e-9);
  EXPECT_NEAR(sole.standing_mm.mean, 2.5, 1e-9);
  EXPECT_TRUE(std::isnan(soleStatistics({NAN}, {true}).fraction_below));
  EXPECT_THROW(soleStatistics({0.0}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
