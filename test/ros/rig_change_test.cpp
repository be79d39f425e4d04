#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "error_text_of.h"
#include "ros/placed_camera.h"
#include "ros/rig_collector.h"
#include "ros/tf_refusal.h"

namespace markerless_mocap {
namespace {

/// A collector of one camera that is known and placed.
class ChangingRig : public ::testing::Test {
 protected:
  ChangingRig() : collector_({"a"}, "world"), info_(infoIn("a_optical")) {
    place(tf_, "a_optical");
    EXPECT_TRUE(collector_.add(0, info_));
    collector_.noteImageSize(0, int(info_.width), int(info_.height));
    EXPECT_FALSE(settle(0.0));
  }
  bool settle(double now) {
    now_ = now;
    change_ = collector_.settle(tf_, now, &remarks_);
    return change_ != RigChange::kNone;
  }
  void move(double x) {
    geometry_msgs::TransformStamped moved;
    moved.header.frame_id = "world";
    moved.child_frame_id = "a_optical";
    moved.transform = samplePose();
    moved.transform.translation.x += x;
    tf_.setTransform(moved, "test", true);
  }
  /// Sends it ten times within a second.
  bool send(const sensor_msgs::CameraInfo& info) {
    bool changed = false;
    for (int i = 0; i < 10; ++i) {
      EXPECT_FALSE(collector_.add(0, info));
      changed = settle(now_ + 0.1) || changed;
    }
    return changed;
  }

  tf2::BufferCore tf_;
  RigCollector collector_;
  sensor_msgs::CameraInfo info_;
  std::vector<std::string> remarks_;
  double now_ = 0.0;
  RigChange change_ = RigChange::kNone;
};

TEST_F(ChangingRig, RepetitionIsNoNews) {
  info_.header.stamp = ros::Time(5, 0);
  EXPECT_FALSE(send(info_));
  EXPECT_TRUE(remarks_.empty());
}

TEST_F(ChangingRig, ACalibrationThatStaysIsTakenOver) {
  info_.K[0] += 1.0;
  EXPECT_TRUE(send(info_));
  EXPECT_EQ(remarks_,
            std::vector<std::string>{"camera_info of a has changed, the new one is used"});
  EXPECT_EQ(collector_.rig(tf_)[0].calibration().K(0, 0), info_.K[0]);
  EXPECT_FALSE(send(info_));
}

TEST_F(ChangingRig, ACalibrationThatChangesAllTheTimeIsNot) {
  const double first = info_.K[0];
  for (int i = 0; i < 40; ++i) {
    info_.K[0] += 0.01;
    collector_.add(0, info_);
    EXPECT_FALSE(settle(now_ + 0.067));
  }
  ASSERT_FALSE(remarks_.empty());
  EXPECT_EQ(remarks_[0], "camera_info of a changes all the time; what came first is used");
  EXPECT_EQ(collector_.rig(tf_)[0].calibration().K(0, 0), first);
}

TEST_F(ChangingRig, ACalibrationOfNoCameraOrOfOtherImagesIsRefused) {
  const sensor_msgs::CameraInfo good = info_;
  info_.width = info_.height = 30000;
  EXPECT_FALSE(send(info_));
  ASSERT_FALSE(remarks_.empty());
  EXPECT_NE(remarks_[0].find("it says 30000 x 30000 pixels, the images have"), std::string::npos);
  // It is said as long as it lasts.
  remarks_.clear();
  EXPECT_FALSE(settle(now_ + 0.1));
  ASSERT_EQ(remarks_.size(), 1u);
  info_ = good;
  info_.D = {1e6, -1e9, 0, 0, 0};
  remarks_.clear();
  EXPECT_FALSE(send(info_));
  ASSERT_FALSE(remarks_.empty());
  EXPECT_NE(remarks_[0].find("but the new one is not used"), std::string::npos);
  EXPECT_FALSE(send(good));
  EXPECT_EQ(collector_.rig(tf_).size(), 1u);
}

TEST_F(ChangingRig, ACalibrationThatIsNotFiniteIsNotOneThatChangesAllTheTime) {
  info_.K[0] = std::nan("");
  EXPECT_FALSE(send(info_));
  ASSERT_FALSE(remarks_.empty());
  EXPECT_EQ(
      remarks_.back(),
      "camera_info of a has changed, but the new one is not used: camera 'a': K holds a value "
      "that is not finite");
  EXPECT_EQ(collector_.rig(tf_).size(), 1u);
}

TEST_F(ChangingRig, ARegionOfInterestIsRefused) {
  info_.roi.x_offset = 8;
  EXPECT_FALSE(send(info_));
  ASSERT_FALSE(remarks_.empty());
  EXPECT_NE(remarks_.back().find("has a region of interest, allowed is the whole image"),
            std::string::npos);
}

TEST_F(ChangingRig, AFrameThatNobodyPlacesCostsNothing) {
  const auto refused = [](const std::string& why) {
    return "camera_info of a has changed, but the new one is not used: " + why;
  };
  info_.header.frame_id = "";
  EXPECT_FALSE(send(info_));
  ASSERT_FALSE(remarks_.empty());
  EXPECT_EQ(remarks_.back(), refused("its frame_id is empty"));
  info_.header.frame_id = "elsewhere";
  EXPECT_FALSE(send(info_));
  EXPECT_EQ(remarks_.back(), refused("tf does not connect elsewhere of a to world"));
  EXPECT_EQ(collector_.doubtOf(0), "");
  EXPECT_EQ(collector_.missing(tf_), "");
  EXPECT_EQ(collector_.rig(tf_).size(), 1u);
  // The lens may be another one, too; then its images are not used.
  info_.K[0] *= 1.05;
  EXPECT_FALSE(send(info_));
  EXPECT_EQ(collector_.doubtOf(0), "tf does not connect elsewhere of a to world");
  place(tf_, "elsewhere");
  EXPECT_TRUE(send(info_));
  EXPECT_EQ(collector_.doubtOf(0), "");
  EXPECT_EQ(collector_.rig(tf_)[0].calibration().K(0, 0), info_.K[0]);
}

TEST_F(ChangingRig, ACameraThatHasMovedIsTakenOverWhenItRests) {
  const std::string left_out = "a has moved by tf, it is left out until it rests";
  for (int i = 1; i <= 10; ++i) {
    move(0.03 * i);
    EXPECT_FALSE(settle(now_ + 0.1));
    // By 3 cm at first, which is more than may be.
    EXPECT_EQ(collector_.doubtOf(0), left_out) << i;
  }
  EXPECT_NEAR(collector_.rig(tf_)[0].position().x(), 1.0, 1e-12);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(settle(now_ + 0.1));
  EXPECT_EQ(remarks_, std::vector<std::string>(14, left_out));
  remarks_.clear();
  EXPECT_TRUE(settle(now_ + 0.15));
  EXPECT_EQ(collector_.doubtOf(0), "");
  EXPECT_EQ(change_, RigChange::kWhileUsed);
  EXPECT_EQ(remarks_, std::vector<std::string>{
                          "a has moved by 0.300 m and 0.0 degrees by tf, its new pose is used"});
  EXPECT_NEAR(collector_.rig(tf_)[0].position().x(), 1.3, 1e-12);
  EXPECT_FALSE(settle(now_ + 1.0));
}

TEST_F(ChangingRig, APoseOfNoCameraIsToldAndNotUsed) {
  const auto expect = [&](const std::string& why) {
    EXPECT_FALSE(settle(now_ + 0.1));
    EXPECT_FALSE(settle(now_ + 0.45));
    EXPECT_FALSE(settle(now_ + 0.45));
    ASSERT_FALSE(remarks_.empty());
    EXPECT_EQ(remarks_.back(), why + "; a is used where it was before");
    EXPECT_EQ(collector_.doubtOf(0), "");
    EXPECT_NEAR(collector_.rig(tf_)[0].position().x(), 1.0, 1e-12);
    remarks_.clear();
  };
  move(1e5);
  expect("camera 'a': the position is farther than 10 km from the origin of the world");
  geometry_msgs::TransformStamped turned;
  turned.header.frame_id = "world";
  turned.child_frame_id = "a_optical";
  turned.transform = samplePose();
  turned.transform.rotation.z = 0.0;
  turned.transform.rotation.w = 1.004;  // tf takes it
  tf_.setTransform(turned, "test", true);
  expect(
      "transform of a is not a rigid one: its quaternion has length 1.004000, allowed is 1, and "
      "finite translation");
}

TEST_F(ChangingRig, ALoopInTfIsToldAndTheCameraUsedWhereItWas) {
  geometry_msgs::TransformStamped link;
  link.transform.rotation.w = 1.0;
  link.header.frame_id = "mount";
  link.child_frame_id = "a_optical";
  tf_.setTransform(link, "test", true);
  std::swap(link.header.frame_id, link.child_frame_id);
  tf_.setTransform(link, "test", true);
  EXPECT_FALSE(settle(now_ + 0.1));
  ASSERT_FALSE(remarks_.empty());
  EXPECT_EQ(remarks_.back(),
            "tf does not connect a_optical of a to world; a is used where it was before");
  EXPECT_EQ(collector_.missing(tf_), "");
  EXPECT_EQ(collector_.rig(tf_).size(), 1u);
}

TEST_F(ChangingRig, APoseOfNoCameraAtTheStartIsForgottenWhenTfIsRight) {
  RigCollector collector({"a"}, "world");
  geometry_msgs::TransformStamped placed;
  placed.header.frame_id = "world";
  placed.child_frame_id = "a_optical";
  placed.transform = samplePose();
  for (double* part : {&placed.transform.rotation.z, &placed.transform.rotation.w}) *part *= 1.004;
  tf_.setTransform(placed, "test", true);
  collector.add(0, info_);
  collector.settle(tf_, 0.0, &remarks_);
  EXPECT_NE(errorTextOf([&] { collector.rig(tf_); }).find("is not a rigid one"), std::string::npos);
  move(0.0);
  collector.settle(tf_, 0.1, &remarks_);
  EXPECT_EQ(collector.rig(tf_).size(), 1u);
}

TEST_F(ChangingRig, TfOfWhatACameraStandsOnConcernsIt) {
  geometry_msgs::TransformStamped link;
  link.transform.rotation.w = 1.0;
  link.header.frame_id = "mount";
  link.child_frame_id = "a_optical";
  tf_.setTransform(link, "test", true);
  place(tf_, "mount");
  place(tf_, "somebody");
  for (const char* frame : {"a_optical", "mount"}) EXPECT_TRUE(collector_.dependsOn(frame, tf_));
  for (const char* frame : {"somebody", ""}) EXPECT_FALSE(collector_.dependsOn(frame, tf_));
}

TEST(TfRefusal, WhatTf2DoesNotTakeIsSaid) {
  const auto why = [](const std::function<void(geometry_msgs::TransformStamped&)>& change) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "world";
    transform.child_frame_id = "a";
    transform.transform = samplePose();
    change(transform);
    tf2::BufferCore tf;
    EXPECT_EQ(tf.setTransform(transform, "test", true), tfRefusal(transform).empty());
    return tfRefusal(transform);
  };
  EXPECT_EQ(why([](auto&) {}), "");
  EXPECT_EQ(why([](auto& t) { t.transform.rotation.x = std::nan(""); }),
            "it holds a value that is not a number");
  EXPECT_EQ(why([](auto& t) { t.transform.translation.y = std::nan(""); }),
            "it holds a value that is not a number");
  EXPECT_EQ(why([](auto& t) { t.transform.rotation = {}; }),
            "its quaternion has length 0.000000, allowed is 1");
  EXPECT_NE(why([](auto& t) { t.transform.rotation.w = 1.0; }), "");
  EXPECT_EQ(why([](auto& t) { t.header.frame_id = "a"; }), "the frame is its own parent");
  EXPECT_EQ(why([](auto& t) { t.child_frame_id = ""; }), "one of its frames has no name");
}

TEST_F(ChangingRig, ACameraThatShakesALittleIsUsed) {
  for (int i = 1; i <= 40; ++i) {
    move(i % 2 ? 0.003 : -0.003);
    EXPECT_FALSE(settle(now_ + 0.1));
    EXPECT_EQ(collector_.doubtOf(0), "");
  }
  ASSERT_FALSE(remarks_.empty());
  EXPECT_EQ(remarks_[0], "a moves by tf; it is used where it was before");
}

TEST_F(ChangingRig, ACameraThatMovesAllTheTimeIsLeftOut) {
  for (int i = 1; i <= 40; ++i) {
    move(i % 2 ? 0.05 : 0.1);
    EXPECT_FALSE(settle(now_ + 0.1));
    EXPECT_NE(collector_.doubtOf(0), "");
  }
}

TEST_F(ChangingRig, ACameraOfAnotherLensIsLeftOutUntilItIsTakenOver) {
  const sensor_msgs::CameraInfo first = info_;
  info_.K[0] *= 1.05;
  EXPECT_FALSE(collector_.add(0, info_));
  EXPECT_FALSE(settle(now_ + 0.1));
  EXPECT_EQ(collector_.doubtOf(0),
            "camera_info of a has changed, it is left out until the new one stays");
  EXPECT_TRUE(send(info_));
  EXPECT_EQ(collector_.doubtOf(0), "");
  // Back for one frame, and of impossible lenses and other images: the rig holds.
  collector_.add(0, first);
  settle(now_ + 0.1);
  EXPECT_NE(collector_.doubtOf(0), "");
  collector_.add(0, info_);
  settle(now_ + 0.1);
  EXPECT_EQ(collector_.doubtOf(0), "");
  sensor_msgs::CameraInfo other = info_;
  other.width = 30000;
  collector_.add(0, other);
  settle(now_ + 0.1);
  EXPECT_EQ(collector_.doubtOf(0), "");
}

TEST_F(ChangingRig, ALensThatWandersForALongTimeCostsNoCamera) {
  for (int i = 0; i < 40; ++i) {
    info_.K[0] *= i % 2 ? 1.05 : 1.0 / 1.05;
    collector_.add(0, info_);
    EXPECT_FALSE(settle(now_ + 0.067));
    if (i > 16) {
      EXPECT_EQ(collector_.doubtOf(0), "") << i;
    }
  }
}

TEST_F(ChangingRig, WhatHasChangedInAPauseIsTakenOverAtOnce) {
  EXPECT_FALSE(settle(now_ + 2.0));
  move(0.3);
  EXPECT_TRUE(settle(now_ + 0.6));
  EXPECT_EQ(change_, RigChange::kAfterPause);
  EXPECT_NEAR(collector_.rig(tf_)[0].position().x(), 1.3, 1e-12);
  info_.K[0] += 1.0;
  collector_.add(0, info_);
  EXPECT_TRUE(settle(now_ + 0.6));
  EXPECT_EQ(change_, RigChange::kAfterPause);
  EXPECT_EQ(collector_.rig(tf_)[0].calibration().K(0, 0), info_.K[0]);
  // Not the one of other images, and not while the rig is used.
  const double good = info_.K[0];
  info_.width = 30000;
  collector_.add(0, info_);
  EXPECT_FALSE(settle(now_ + 0.6));
  info_.width = uint32_t(collector_.rig(tf_)[0].width());
  info_.K[0] += 1.0;
  collector_.add(0, info_);
  move(0.0);
  EXPECT_FALSE(settle(now_ + 0.1));
  EXPECT_EQ(collector_.rig(tf_)[0].calibration().K(0, 0), good);
}

}  // namespace
}  // namespace markerless_mocap
