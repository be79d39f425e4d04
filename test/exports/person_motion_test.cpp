#include "error_text_of.h"
#include "exports/export_fixture.h"

namespace markerless_mocap {
namespace {

using Motion = MovingPerson;

TEST_F(Motion, BeginsAndEndsWithAPose) {
  std::vector<PersonFrame> all = frames(8);
  for (const size_t f : {0, 1, 7}) all[f].T_world_link.clear();
  const PersonMotion recorded = personMotion(body_, all);
  EXPECT_EQ(recorded.frames.size(), 5u);
  EXPECT_DOUBLE_EQ(recorded.start_s, 0.08);
  EXPECT_EQ(recorded.frames.front().stamp_ns, kStart + 2 * kStep);
}

TEST_F(Motion, WithoutAPoseThereIsNone) {
  std::vector<PersonFrame> all = frames(3);
  for (PersonFrame& frame : all) frame.T_world_link.clear();
  EXPECT_EQ(errorTextOf<std::exception>([&] { personMotion(body_, all); }), "no frame has a pose");
  EXPECT_EQ(errorTextOf<std::exception>([&] { personMotion(body_, {}); }), "no frame has a pose");
}

TEST_F(Motion, MissingFramesBecomeGaps) {
  std::vector<PersonFrame> all = frames(12);
  all.erase(all.begin() + 5, all.begin() + 7);
  const PersonMotion recorded = personMotion(body_, all);
  ASSERT_EQ(recorded.frames.size(), 12u);
  EXPECT_FALSE(recorded.frames[5].hasPose());
  EXPECT_FALSE(recorded.frames[6].hasPose());
  EXPECT_EQ(recorded.frames[6].stamp_ns, kStart + 6 * kStep);
  EXPECT_LT(recorded.irregularity(), 1e-9);
}

TEST_F(Motion, FilledGapsAreCloseToTheTruth) {
  std::vector<PersonFrame> all = frames(20);
  for (const size_t f : {8, 9}) all[f].T_world_link.clear();
  for (const size_t f : {13, 14}) hideLeftArm(&all[f]);
  PersonMotion recorded = personMotion(body_, all);
  fillGaps(0.12, &recorded);
  for (const int f : {8, 9, 13, 14})
    for (const char* name : {"body", "head", "l_wrist", "r_ankle"}) {
      const Eigen::Isometry3d& truth = link(frameAt(f), name);
      const Eigen::Isometry3d found = link(recorded.frames[size_t(f)], name);
      // 7 to 8 mm at the wrists; a straight line between the frames is 30 mm off.
      EXPECT_LT((found.translation() - truth.translation()).norm(), 0.01) << f << ' ' << name;
    }
  const size_t wrist = size_t(body_->linkIndex("l_wrist"));
  EXPECT_TRUE(recorded.frames[13].filled[wrist]);
  EXPECT_FALSE(recorded.frames[13].filled[0]);
  EXPECT_FALSE(recorded.frames[12].filled[wrist]);
}

TEST_F(Motion, LongerGapsStay) {
  std::vector<PersonFrame> all = frames(20);
  for (const size_t f : {8, 9, 10}) hideLeftArm(&all[f]);
  PersonMotion recorded = personMotion(body_, all);
  fillGaps(0.12, &recorded);
  EXPECT_FALSE(recorded.frames[9].isKnown(body_->linkIndex("l_wrist")));
  const auto gaps = jointGaps(recorded, exportSkeleton(*body_, "motionbuilder"));
  ASSERT_EQ(gaps.size(), 4u) << "clavicle, shoulder, elbow, wrist";
  EXPECT_EQ(gaps[1].joint, "LeftArm");
  EXPECT_EQ(gaps[1].first, 8u);
  EXPECT_EQ(gaps[1].last, 10u);
  EXPECT_FALSE(gaps[1].filled);
}

TEST_F(Motion, GapAtTheBeginOfAnArmStays) {
  std::vector<PersonFrame> all = frames(6);
  hideLeftArm(&all[0]);
  hideLeftArm(&all[5]);
  PersonMotion recorded = personMotion(body_, all);
  fillGaps(10.0, &recorded);
  EXPECT_FALSE(recorded.frames[0].isKnown(body_->linkIndex("l_wrist")));
  EXPECT_FALSE(recorded.frames[5].isKnown(body_->linkIndex("l_wrist")));
}

TEST_F(Motion, MisfitIsTheDistanceFromTheBodysLengths) {
  std::vector<PersonFrame> all = frames(3);
  EXPECT_LT(misfit(personMotion(body_, all)), 1e-9);
  const size_t elbow = size_t(body_->linkIndex("l_elbow"));
  all[1].T_world_link[elbow].translation().z() += 0.02;
  EXPECT_NEAR(misfit(personMotion(body_, all)), 0.02, 1e-9);
}

}  // namespace
}  // namespace markerless_mocap
