#include "ros/rig_collector.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

#include "camera/blind_camera.h"
#include "error_text_of.h"
#include "markerless_mocap/camera/rig_file.h"
#include "ros/placed_camera.h"

namespace markerless_mocap {
namespace {

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
            "cannot read the rig /no/such/file: there is no such file");
}

TEST(RigCollector, AFirstCalibrationOfNoCameraIsReplacedAtOnce) {
  RigCollector collector({"a"}, "world");
  tf2::BufferCore tf;
  place(tf, "a_optical");
  sensor_msgs::CameraInfo bad = infoIn("a_optical");
  bad.K.assign(0.0);
  collector.add(0, bad);
  std::vector<std::string> remarks;
  EXPECT_EQ(collector.settle(tf, 0.0, &remarks), RigChange::kNone);
  EXPECT_NE(errorTextOf([&] { collector.rig(tf); }).find("K is all zero"), std::string::npos);
  collector.add(0, infoIn("a_optical"));
  EXPECT_EQ(collector.settle(tf, 0.1, &remarks), RigChange::kWhileUsed);
  EXPECT_EQ(collector.rig(tf).size(), 1u);
}

/// Four cameras, three of which are enough. The last one is not placed.
class RigWithALackingCamera : public ::testing::Test {
 protected:
  RigWithALackingCamera() : collector_({"a", "b", "c", "d"}, "world", "", 3) {
    for (const char* name : {"a", "b", "c"}) place(tf_, std::string(name) + "_optical");
    for (size_t i = 0; i < 3; ++i)
      collector_.add(i, infoIn(std::string(1, char('a' + i)) + "_optical"));
  }
  RigChange settle(double now) {
    remarks_.clear();
    return collector_.settle(tf_, now, &remarks_);
  }
  /// Whether the rig changes within some seconds.
  bool goesWithout(double from) {
    bool changed = false;
    for (double now = from; now < from + 3.0; now += 0.1)
      changed = settle(now) != RigChange::kNone || changed;
    return changed && collector_.missing(tf_).empty();
  }

  tf2::BufferCore tf_;
  RigCollector collector_;
  std::vector<std::string> remarks_;
};

TEST_F(RigWithALackingCamera, IsWaitedForAWhile) {
  EXPECT_EQ(settle(0.0), RigChange::kNone);
  EXPECT_EQ(settle(0.4), RigChange::kNone);
  EXPECT_EQ(collector_.missing(tf_), "no camera_info has been received from d");
}

TEST_F(RigWithALackingCamera, IsUsedWithoutItUntilItIsKnown) {
  ASSERT_TRUE(goesWithout(0.0));
  EXPECT_EQ(remarks_, std::vector<std::string>{"no camera_info has been received from d; the other "
                                               "cameras are used without it"});
  EXPECT_EQ(collector_.doubtOf(3), "no camera_info has been received from d");
  EXPECT_EQ(collector_.doubtOf(0), "");
  const CameraRig rig = collector_.rig(tf_);
  ASSERT_EQ(rig.size(), 4u);
  EXPECT_TRUE(isBlind(rig[3]));
  EXPECT_EQ(rig[3].name(), "d");
  EXPECT_FALSE(isBlind(rig[2]));
  // Its camera_info comes, then its transform.
  EXPECT_FALSE(collector_.add(3, infoIn("d_optical"))) << "the rig that is used stays";
  EXPECT_EQ(settle(3.1), RigChange::kNone);
  EXPECT_EQ(collector_.doubtOf(3), "tf does not connect d_optical of d to world");
  place(tf_, "d_optical");
  EXPECT_EQ(settle(3.2), RigChange::kWhileUsed);
  EXPECT_EQ(remarks_, std::vector<std::string>{"d is known now and used"});
  EXPECT_EQ(collector_.doubtOf(3), "");
  EXPECT_FALSE(isBlind(collector_.rig(tf_)[3]));
}

TEST_F(RigWithALackingCamera, AFirstCalibrationOfNoCameraCostsThatCamera) {
  place(tf_, "d_optical");
  sensor_msgs::CameraInfo bad = infoIn("d_optical");
  bad.K.assign(0.0);
  collector_.add(3, bad);
  ASSERT_TRUE(goesWithout(0.0));
  EXPECT_NE(collector_.doubtOf(3).find("K is all zero"), std::string::npos);
  EXPECT_TRUE(isBlind(collector_.rig(tf_)[3]));
  collector_.add(3, infoIn("d_optical"));
  EXPECT_EQ(settle(3.1), RigChange::kWhileUsed);
  EXPECT_FALSE(isBlind(collector_.rig(tf_)[3]));
}

TEST_F(RigWithALackingCamera, TooFewCamerasAreNotEnough) {
  RigCollector collector({"a", "b", "c", "d"}, "world", "", 4);
  for (size_t i = 0; i < 3; ++i)
    collector.add(i, infoIn(std::string(1, char('a' + i)) + "_optical"));
  for (double now = 0.0; now < 5.0; now += 0.1)
    EXPECT_EQ(collector.settle(tf_, now, &remarks_), RigChange::kNone);
  EXPECT_EQ(collector.missing(tf_), "no camera_info has been received from d");
}

TEST(RigCollector, AFrameOfAnotherCameraIsNotTaken) {
  RigCollector collector({"a", "b"}, "world");
  tf2::BufferCore tf;
  place(tf, "a_optical");
  place(tf, "b_optical");
  collector.add(0, infoIn("a_optical"));
  collector.add(1, infoIn("b_optical"));
  std::vector<std::string> remarks;
  collector.settle(tf, 0.0, &remarks);
  collector.add(0, infoIn("b_optical"));
  for (double now : {0.1, 0.3, 0.5, 0.7, 0.9})
    EXPECT_EQ(collector.settle(tf, now, &remarks), RigChange::kNone);
  ASSERT_FALSE(remarks.empty());
  EXPECT_EQ(remarks.back(),
            "camera_info of a has changed, but the new one is not used: its frame_id b_optical is "
            "that of b, allowed is one of its own");
  EXPECT_EQ(collector.doubtOf(0), "");
  // The other one gives it up.
  place(tf, "c_optical");
  collector.add(1, infoIn("c_optical"));
  bool changed = false;
  for (double now : {1.0, 1.2, 1.4, 1.6, 1.8})
    changed = collector.settle(tf, now, &remarks) != RigChange::kNone || changed;
  EXPECT_TRUE(changed);
  EXPECT_EQ(remarks.back(), "camera_info of a has changed, the new one is used");
}

}  // namespace
}  // namespace markerless_mocap
