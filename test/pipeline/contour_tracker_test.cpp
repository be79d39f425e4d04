#include <gtest/gtest.h>

#include "error_text_of.h"
#include "markerless_mocap/body/body_urdf.h"
#include "pipeline/contour_method.h"

namespace markerless_mocap {
namespace {

TEST_F(ContourMethodTest, ReportsTheMeanBodyWithItsUncertaintyUntilThePersonIsMeasured) {
  make();
  BodyPose pose = show(0);
  EXPECT_EQ(pose.status, PoseStatus::kLost) << "nothing has moved yet";
  EXPECT_EQ(pose.reason, beingMeasured(1));
  const auto believed = tracker->body();
  EXPECT_FALSE(believed->shape_estimated);
  int frame = 1, poses = 1;
  while ((pose = show(frame)).reason != "the body has just been measured") {
    ASSERT_LT(frame, 30);
    EXPECT_EQ(pose.status, frame == 1 ? PoseStatus::kReinitialized : PoseStatus::kTracked) << frame;
    EXPECT_LT(error(pose, frame), 0.06) << frame;
    for (const double sigma : pose.part_sigma_m) EXPECT_GT(sigma, 0.015) << "of the lengths";
    EXPECT_TRUE(tracker->body() == believed) << frame;
    if (pose.reason != beingMeasured(poses)) ++poses;
    EXPECT_EQ(pose.reason, beingMeasured(poses)) << frame;
    ++frame;
  }
  ++frame;
  EXPECT_EQ(poses, kMeasuringPoses - 1);
  EXPECT_EQ(pose.status, PoseStatus::kLost) << "the fit was still the other body's";
  pose = show(frame);
  EXPECT_EQ(pose.status, PoseStatus::kReinitialized);
  EXPECT_TRUE(pose.reason.empty());
  const auto measured = tracker->body();
  EXPECT_TRUE(measured->shape_estimated);
  EXPECT_LT(offBy(measured->shape),
            0.5 * offBy(resources.shape_statistics.meanShape(options.person.stature)));
  EXPECT_EQ(measured->urdf, fillUrdfTemplate(resources.urdf_template, resources.body_id,
                                             proportionsOf(measured->shape)));
  for (int i = 1; i <= 12; ++i) {
    pose = show(frame + i);
    EXPECT_EQ(pose.status, PoseStatus::kTracked) << i;
    EXPECT_LT(error(pose, frame + i), 0.02) << i;
    EXPECT_TRUE(tracker->body() == measured) << "it changes once";
  }
}

TEST_F(ContourMethodTest, ThePoseIsReportedBeforeABetterOneIsLookedFor) {
  makeMeasured();
  for (int frame = 0; frame < 3; ++frame) show(frame);
  std::vector<BodyPose> reported;
  int asked_after = 0;  // whether there is time for a search
  ReadyProducts products({hull, parts, PoseTree{}});
  const std::vector<cv::Mat> masks = masksAt(3);
  const auto behind = [&] {
    asked_after += !reported.empty();
    return false;
  };
  const auto report = [&](const BodyPose& pose) { reported.push_back(pose); };
  const BodyPose pose =
      tracker->update({stamp_ns += kFrame_ns, masks, {}, products, behind, false, {}, report});
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_EQ(reported[0].status, PoseStatus::kTracked);
  EXPECT_EQ(reported[0].angles, pose.angles);
  EXPECT_TRUE(reported[0].T_world_body.matrix() == pose.T_world_body.matrix());
  EXPECT_GT(asked_after, 0);
}

TEST_F(ContourMethodTest, MeasuringBeginsWithTheStatureThatExplainsTheMasksBest) {
  options.person.stature = 1.9;
  make();
  EXPECT_EQ(tracker->body()->shape, resources.shape_statistics.meanShape(1.9));
  show(0);
  EXPECT_EQ(tracker->body()->shape, resources.shape_statistics.meanShape(1.7))
      << "of 1.5, 1.6, ...";
  EXPECT_FALSE(tracker->body()->shape_estimated);
}

TEST_F(ContourMethodTest, MeasuresInBackgroundWhileInstantsGoOn) {
  make();
  for (int frame = 0; !tracker->body()->shape_estimated && frame < 30; ++frame) show(frame);
  const ShapeParameters at_once = tracker->body()->shape;
  resources.in_background = true;
  make();
  int frame = 0;
  for (; !tracker->body()->shape_estimated && frame < 1000; ++frame) show(frame);
  ASSERT_TRUE(tracker->body()->shape_estimated);
  EXPECT_EQ(tracker->body()->shape, at_once);
  EXPECT_LT(error(show(frame), frame), 0.02);
}

TEST_F(ContourMethodTest, MeasuresFromTheFewPosesThereAreWhenAskedTo) {
  make();
  tracker->estimateShapeNow();
  EXPECT_FALSE(tracker->body()->shape_estimated) << "from nothing";
  for (int frame = 0; frame < 6; ++frame) show(frame);
  tracker->estimateShapeNow();
  EXPECT_TRUE(tracker->body()->shape_estimated);
  const BodyPose pose = show(6);
  EXPECT_EQ(pose.status, PoseStatus::kReinitialized);
  EXPECT_LT(error(pose, 6), 0.03);
}

TEST_F(ContourMethodTest, SizesThatAreGivenAreNotMeasured) {
  makeMeasured();
  const auto body = tracker->body();
  EXPECT_TRUE(body->shape_estimated);
  EXPECT_EQ(body->shape, truth());
  for (int frame = 0; frame < 8; ++frame) {
    const BodyPose pose = show(frame);
    EXPECT_EQ(pose.status, frame ? PoseStatus::kTracked : PoseStatus::kReinitialized);
    EXPECT_LT(error(pose, frame), 0.012) << frame;
    EXPECT_GT(pose.silhouette_overlap, 0.9);
    for (size_t part = 0; part < kPartCount; ++part) {
      EXPECT_TRUE(pose.part_seen[part]) << part;
      EXPECT_GT(pose.part_sigma_m[part], 0.0) << part;
      EXPECT_LT(pose.part_sigma_m[part], 0.06) << part;
    }
  }
  EXPECT_TRUE(tracker->body() == body);
}

TEST_F(ContourMethodTest, MeasuresNothingWhenToldNotTo) {
  options.person.measure = false;
  make();
  const auto body = tracker->body();
  EXPECT_EQ(body->shape, resources.shape_statistics.meanShape(1.75));
  for (int frame = 0; frame < 15; ++frame) {
    const BodyPose pose = show(frame);
    EXPECT_NE(pose.status, PoseStatus::kLost);
    for (const double sigma : pose.part_sigma_m) EXPECT_GT(sigma, 0.015) << "of the lengths";
    EXPECT_GT(pose.part_sigma_m[4], 0.025) << "of the shank";
  }
  EXPECT_TRUE(tracker->body() == body);
  EXPECT_FALSE(body->shape_estimated);
}

TEST_F(ContourMethodTest, FollowsByMasksAloneOnceStarted) {
  makeMeasured();
  EXPECT_EQ(showMasks(0).status, PoseStatus::kLost) << "nothing to start from";
  show(1);
  for (int frame = 2; frame < 10; ++frame) {
    const BodyPose pose = showMasks(frame);
    EXPECT_EQ(pose.status, PoseStatus::kTracked);
    EXPECT_LT(error(pose, frame), 0.012) << frame;
  }
}

TEST_F(ContourMethodTest, IsLostWithTheMasksAndFoundAgain) {
  makeMeasured();
  for (int frame = 0; frame < 3; ++frame) show(frame);
  const BodyPose gone = showNothing();
  EXPECT_EQ(gone.status, PoseStatus::kLost);
  EXPECT_EQ(gone.reason, "the person is visible in 0 silhouettes, at least 2 are needed");
  const BodyPose unknown = showMasks(4);
  EXPECT_EQ(unknown.status, PoseStatus::kLost);
  EXPECT_EQ(unknown.reason, "there is no hull");
  const BodyPose found = show(5);
  EXPECT_EQ(found.status, PoseStatus::kReinitialized);
  EXPECT_LT(error(found, 5), 0.012);
  EXPECT_EQ(show(6).status, PoseStatus::kTracked);
}

TEST_F(ContourMethodTest, DoesNotStartOnWhatIsNoPerson) {
  makeMeasured();
  cv::Mat box = cv::Mat::zeros(240, 320, CV_8UC1);
  box(cv::Rect(60, 90, 200, 60)) = 255;
  const BodyPose pose = show(std::vector<cv::Mat>(rig.size(), box), treeOf(person, at(0), false));
  EXPECT_EQ(pose.status, PoseStatus::kLost);
  EXPECT_EQ(pose.reason.rfind("no pose covers the silhouettes, the best overlap is 0.", 0), 0u)
      << pose.reason;
}

TEST_F(ContourMethodTest, StampsThatGoBackAndResetRestartTheTrack) {
  makeMeasured();
  for (int frame = 0; frame < 3; ++frame) show(frame);
  const auto body = tracker->body();
  stamp_ns = 0;
  EXPECT_EQ(show(3).status, PoseStatus::kReinitialized);
  EXPECT_EQ(show(4).status, PoseStatus::kTracked);
  tracker->reset();
  EXPECT_EQ(show(5).status, PoseStatus::kReinitialized);
  EXPECT_TRUE(tracker->body() == body);
}

TEST_F(ContourMethodTest, ATreeThatTakesLeftForRightIsSeenThrough) {
  makeMeasured();
  bool told = false;
  for (int frame = 0; frame < 15; ++frame) {
    const BodyPose pose = show(masksAt(frame), treeOf(person, at(frame), true));
    if (pose.status == PoseStatus::kLost) {
      EXPECT_EQ(pose.reason, "a person was found, but front and back cannot be distinguished yet");
      EXPECT_FALSE(told) << frame;
      continue;
    }
    EXPECT_EQ(pose.status, told ? PoseStatus::kTracked : PoseStatus::kReinitialized) << frame;
    EXPECT_LT(error(pose, frame), 0.02) << frame;
    told = true;
  }
  EXPECT_TRUE(told);
}

TEST_F(ContourMethodTest, RefusesMasksThatDoNotFitTheRig) {
  makeMeasured();
  std::vector<cv::Mat> masks = masksAt(0);
  masks.pop_back();
  EXPECT_EQ(errorTextOf([&] { show(masks, PoseTree{}); }),
            "contour: 4 masks were given, the rig has 5 cameras");
  masks.push_back(cv::Mat::zeros(10, 10, CV_8UC1));
  EXPECT_NE(errorTextOf([&] { show(masks, PoseTree{}); }).find("cam4"), std::string::npos);
}

TEST_F(ContourMethodTest, NeedsCamerasAndAUrdf) {
  rig.clear();
  EXPECT_EQ(errorTextOf([&] { make(); }),
            "pose_fitting/method is contour, which needs a rig with cameras; without cameras, "
            "allowed is hsiao");
  options.method = "hsiao";
  make();
  EXPECT_FALSE(tracker->body()->shape_estimated);
  options = contourOptions();
  rig = drawnRig(2);
  resources.urdf_template = "<robot name=\"nobody\"><link name=\"a\"/></robot>";
  EXPECT_THROW(make(), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
