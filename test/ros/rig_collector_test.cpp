#include "ros/rig_collector.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

#include "error_text_of.h"
#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"
#include "ros/sample_camera.h"

namespace markerless_mocap {
namespace {

sensor_msgs::CameraInfo infoIn(const std::string& frame) {
  sensor_msgs::CameraInfo info = messageFromCalibration(sampleCalibration());
  info.header.frame_id = frame;
  return info;
}

void place(tf2::BufferCore& tf, const std::string& frame) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "world";
  transform.child_frame_id = frame;
  transform.transform = samplePose();
  tf.setTransform(transform, "test", true);
}

TEST(RigCollector, NamesTheCamerasWithoutInfo) {
  RigCollector collector({"a", "b", "c"}, "world");
  collector.add(1, infoIn("b_optical"));
  EXPECT_EQ(collector.missing(tf2::BufferCore()), "no camera_info has been received from a, c");
}

TEST(RigCollector, NamesTheFrameThatTfDoesNotConnect) {
  RigCollector collector({"a", "b"}, "world");
  collector.add(0, infoIn("a_optical"));
  collector.add(1, infoIn("b_optical"));
  tf2::BufferCore tf;
  place(tf, "a_optical");
  EXPECT_EQ(collector.missing(tf), "tf does not connect b_optical of b to world");
  EXPECT_EQ(errorTextOf([&] { collector.rig(tf); }), collector.missing(tf));
}

TEST(RigCollector, NeverTakesAnEmptyFrameForTheWorld) {
  RigCollector collector({"a"}, "world");
  collector.add(0, infoIn(""));
  EXPECT_EQ(collector.missing(tf2::BufferCore()), "camera_info of a has an empty frame_id");
}

TEST(RigCollector, GivesTheRigInTheOrderOfTheNames) {
  RigCollector collector({"a", "b"}, "world");
  collector.add(1, infoIn("b_optical"));
  collector.add(0, infoIn("a_optical"));
  tf2::BufferCore tf;
  place(tf, "a_optical");
  place(tf, "b_optical");
  EXPECT_EQ(collector.missing(tf), "");
  const CameraRig rig = collector.rig(tf);
  ASSERT_EQ(rig.size(), 2u);
  EXPECT_EQ(rig[0].name(), "a");
  EXPECT_EQ(rig[1].name(), "b");
  EXPECT_TRUE(rig[0].position().isApprox(Eigen::Vector3d(1.0, 2.0, 3.0), 1e-12));
}

class RigFromFile : public ::testing::Test {
 protected:
  RigFromFile() {
    std::vector<CameraCalibration> rig(3, sampleCalibration());
    for (size_t i = 0; i < 3; ++i) rig[i].name = std::string(1, char('a' + i));
    rig[1].T_world_camera.translation().z() = 7.0;
    writeRig(file_, rig);
  }
  ~RigFromFile() override { std::remove(file_.c_str()); }

  const std::string file_ = ::testing::TempDir() + "rig_" + std::to_string(getpid()) + ".yaml";
};

TEST_F(RigFromFile, StandsForCameraInfoAndTfEvenIfThoseSayOtherwise) {
  RigCollector collector({"b", "a"}, "world", file_);
  EXPECT_TRUE(collector.isFromFile());
  EXPECT_EQ(collector.missing(tf2::BufferCore()), "");
  EXPECT_FALSE(collector.add(0, infoIn("b_optical")));
  tf2::BufferCore tf;
  place(tf, "b_optical");
  const CameraRig rig = collector.rig(tf);
  ASSERT_EQ(rig.size(), 2u);
  EXPECT_EQ(rig[0].name(), "b");
  EXPECT_EQ(rig[0].position(), Eigen::Vector3d(1.0, 2.0, 7.0));
  EXPECT_EQ(rig[1].name(), "a");
}

TEST_F(RigFromFile, CamerasThatAreLackingOrLeftOverAreNamed) {
  EXPECT_EQ(errorTextOf([&] {
              RigCollector({"a", "left", "d"}, "world", file_);
            }),
            file_ + ": the rig lacks left, d, its cameras are a, b, c");
  EXPECT_EQ(RigCollector({"b"}, "world", file_).unusedCameras(),
            file_ + " also has a, c, which is not used");
  EXPECT_EQ(RigCollector({"c", "b", "a"}, "world", file_).unusedCameras(), "");
  EXPECT_EQ(errorTextOf<std::runtime_error>([] { RigCollector({"a"}, "world", "/no/such/file"); }),
            "cannot read the rig /no/such/file");
}

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
  ASSERT_EQ(remarks_.size(), 1u);
  EXPECT_NE(remarks_[0].find("it says 30000 x 30000 pixels, the images have"), std::string::npos);
  info_ = good;
  info_.D = {1e6, -1e9, 0, 0, 0};
  EXPECT_FALSE(send(info_));
  ASSERT_EQ(remarks_.size(), 2u);
  EXPECT_NE(remarks_[1].find("but the new one is not used"), std::string::npos);
  EXPECT_FALSE(send(good));
  EXPECT_EQ(collector_.rig(tf_).size(), 1u);
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
